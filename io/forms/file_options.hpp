#pragma once

#include <array>
#include <optional>
#include <span>

#include "io/colours/colouring.hpp"
#include "mesher/cells/cell_materials.hpp"
#include "mesher/cells/elastic_choices.hpp"
#include "mesher/plane/voxels/voxel_grid.hpp"

namespace pcvt {

/// Whether each cell of a glTF file is a node of its own: where there are few cells, always, never.
enum class GltfNodes { kBySize, kCells, kOne };

/// The choices of a user, with their words in options and their numbers in pcvt.h.
struct GltfNodesRow {
    GltfNodes nodes;
    const char* word;
    int abi_value;
};
inline constexpr std::array kGltfNodes{GltfNodesRow{GltfNodes::kCells, "cells", 1},
                                       GltfNodesRow{GltfNodes::kOne, "one", 2}};

/// The elements of a solver's file of triangles: triangles that assume a state of the plane, or one
/// layer of wedges above them, of six or fifteen nodes.
enum class PlaneElement { kStrain, kStress, kWedge6, kWedge15 };

/// One row of the table of choices (mesher/base/choices.hpp): the word is how Abaqus and CalculiX
/// name the type of wedges, and begin the name of the type of triangles.
struct PlaneElementRow {
    PlaneElement element;
    const char* word;
    int abi_value;
    /// Of wedges that of their triangles; else 0.
    int wedge_order = 0;
};
inline constexpr std::array kPlaneElements{PlaneElementRow{PlaneElement::kStrain, "CPE", 0},
                                           PlaneElementRow{PlaneElement::kStress, "CPS", 1},
                                           PlaneElementRow{PlaneElement::kWedge6, "C3D6", 2, 1},
                                           PlaneElementRow{PlaneElement::kWedge15, "C3D15", 3, 2}};

constexpr const PlaneElementRow& plane_element_row(PlaneElement element) {
    return kPlaneElements[static_cast<std::size_t>(element)];
}

/// Whether the elements are wedges.
constexpr bool are_wedges(PlaneElement element) {
    return plane_element_row(element).wedge_order > 0;
}

/// The wedges over triangles of an order.
constexpr PlaneElement wedge_element(int order) {
    return order == 2 ? PlaneElement::kWedge15 : PlaneElement::kWedge6;
}

/// The parts of a solver input besides the mesh: none, or materials and steps that run.
enum class SolverJob { kNone, kElastic };

/// One row of the table of choices (mesher/base/choices.hpp).
struct SolverJobRow {
    SolverJob job;
    const char* word;
    int abi_value;
};
inline constexpr std::array kSolverJobs{SolverJobRow{SolverJob::kElastic, "elastic", 1}};

inline constexpr int kDefaultPixels = 1024;

/// The surfaces that a file shows: every cell of a tile, or the boundary of the tile.
enum class SurfaceForm { kCells, kBoundary };

struct SurfaceFormRow {
    SurfaceForm form;
    const char* word;
    int abi_value;
};
inline constexpr std::array kSurfaceForms{SurfaceFormRow{SurfaceForm::kCells, "cells", 0},
                                          SurfaceFormRow{SurfaceForm::kBoundary, "boundary", 1}};

/// The values that a writer may need besides the tile. The rows of the table of formats name the
/// members that a format takes.
struct FileOptions {
    /// The densities at sites 0 to n - 1 of one period of a graded mesh; else empty.
    std::span<const double> site_densities = {};
    /// Phases and orientations of the cells, which must outlive the options; null: none.
    const CellMaterials* materials = nullptr;
    /// The orbit of sites 0 to n - 1 of one period in a run with a symmetry; else empty.
    std::span<const int> site_orbits = {};
    SiteQuantities quantities() const { return {site_densities, materials, site_orbits}; }
    /// The quantity that colours show; `nullopt`: each format has its own default.
    std::optional<Colouring> colouring = {};
    /// The background of pictures; `nullopt`: the page behind the picture shows through.
    std::optional<Colour> background = {};
    GltfNodes gltf_nodes = GltfNodes::kBySize;
    /// PLY: 32-bit coordinates and triangles, as viewers need them.
    bool single_precision = false;
    /// Images: the number of pixels of a row; 0: kDefaultPixels.
    int pixels = 0;
    /// Voxel images: the numbers of voxels and of layers; 0 x 0 voxels: default_voxels().
    plane::VoxelCounts voxels = {};
    /// MPAS: f and beta of the Coriolis parameter f + beta y; `nullopt`: none.
    std::optional<std::array<double, 2>> coriolis = {};
    /// SVG and DXF for cutters: the width of the tile in millimetres; 0: a coloured picture as SVG,
    /// and DXF in the unit of the period vectors.
    double cut_width = 0;
    /// Inputs of solvers that name the types of their elements.
    PlaneElement element = PlaneElement::kStrain;
    /// Inputs of solvers that can hold more than the mesh.
    SolverJob job = SolverJob::kNone;
    /// Inputs of solvers that hold elastic constants.
    ElasticChoices elastic = {};
    /// The height of one layer of prisms or wedges, length units; 0: the square root of the mean
    /// area of their bases.
    double thickness = 0;
    /// In space, the surfaces that files show.
    SurfaceForm surfaces = SurfaceForm::kCells;
};

}  // namespace pcvt
