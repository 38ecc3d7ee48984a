// Functions that the module leaves out, because neither the page nor the package offers them.

#include "io/graphics/stl_proof.hpp"
#include "io/openfoam/foam_space_notes.hpp"
#include "io/openfoam/foam_tetrahedra.hpp"
#include "io/run_files/material_file.hpp"
#include "io/solvers/inp_tetrahedra.hpp"
#include "io/solvers/inp_wedges.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/cvt/centroid_cells.hpp"
#include "mesher/space/box/box_cells.hpp"
#include "mesher/space/box/box_origin.hpp"
#include "mesher/space/box/box_sides.hpp"
#include "mesher/space/cvt/centroid_cells.hpp"
#include "mesher/space/grains/grains.hpp"

namespace pcvt {
namespace {

[[noreturn]] void refuse_centroids() {
    throw InvalidInput("this module does not find sites of centroids; take the command");
}

[[noreturn]] void refuse_closed_surfaces() {
    throw InvalidInput("this module has no .stl files; take the command");
}

[[noreturn]] void refuse_grains_of_cases() {
    throw InvalidInput("this module has no tetrahedra in .foam cases; take the command");
}

[[noreturn]] void refuse_solver_tetrahedra() {
    throw InvalidInput("this module has no .inp files in space; take the command");
}

[[noreturn]] void refuse_wedges() {
    throw InvalidInput("this module has no wedges C3D6 or C3D15; take the command");
}

}  // namespace

void add_material_file(const std::string& /*name*/, std::string_view /*text*/,
                       ElasticChoices& /*choices*/) {
    throw InvalidInput("this module reads no files of materials; take the command");
}

double wedge_thickness(const plane::Tile& /*tile*/, const FileOptions& /*options*/) {
    refuse_wedges();
}

void extrude(const plane::Tile& /*tile*/, const TriangleCells& /*cells*/,
             const CellMaterials& /*materials*/, double /*thickness*/, InpForm& /*form*/) {
    refuse_wedges();
}

void flatten(FileWedges& /*file*/) { refuse_wedges(); }

std::vector<EncodedFile> encode_tetrahedra_inp(const space::TetrahedralMesh& /*mesh*/,
                                               const FileOptions& /*options*/,
                                               const std::string& /*path*/) {
    refuse_solver_tetrahedra();
}

bool holds_inp_tetrahedra(const EncodedFile& inp) { return states_tetrahedra(inp.bytes); }

TetrahedralTile decode_inp_tetrahedra(const EncodedFile& /*inp*/) { refuse_solver_tetrahedra(); }

void compare_inp_tetrahedra(const EncodedFile& /*inp*/, const TetrahedralTile& /*tile*/) {
    refuse_solver_tetrahedra();
}

ClosedSurfaces closed_surfaces(const space::PolyhedralMesh& /*mesh*/, SurfaceForm /*form*/) {
    refuse_closed_surfaces();
}

ClosedSurfaces closed_surfaces(const space::TetrahedralMesh& /*mesh*/, SurfaceForm /*form*/) {
    refuse_closed_surfaces();
}

std::vector<EncodedFile> encode_stl(const ClosedSurfaces& /*surfaces*/,
                                    const std::string& /*path*/) {
    refuse_closed_surfaces();
}

StlFile decode_stl(const EncodedFile& /*file*/) { refuse_closed_surfaces(); }

std::optional<SurfaceForm> stl_form(const StlFile& /*stl*/) { refuse_closed_surfaces(); }

StlProof prove_stl(const EncodedFile& /*file*/) { refuse_closed_surfaces(); }

bool holds_surfaces(const EncodedFile& /*file*/, const ClosedSurfaces& /*surfaces*/) {
    refuse_closed_surfaces();
}

std::vector<EncodedFile> encode_foam_tetrahedra(const space::TetrahedralMesh& /*mesh*/,
                                                const CellMaterials* /*materials*/,
                                                const std::string& /*folder*/) {
    refuse_grains_of_cases();
}

bool is_foam_of_tetrahedra(const std::vector<EncodedFile>& files) {
    return is_foam_of("tetrahedra", files);
}

space::TetrahedralMesh with_sorted_corners(space::TetrahedralMesh mesh) { return mesh; }

TetrahedralTile decode_foam_tetrahedra(const std::vector<EncodedFile>& /*files*/,
                                       double /*tolerance*/) {
    refuse_grains_of_cases();
}

void compare_foam_tetrahedra(const std::vector<EncodedFile>& /*files*/,
                             const TetrahedralTile& /*tile*/, double /*tolerance*/) {
    refuse_grains_of_cases();
}

plane::CentroidCells plane::fit_areas_and_centroids(const Lattice& /*lattice*/,
                                                    const Points& /*centroids*/,
                                                    const AreaCvtOptions& /*options*/) {
    refuse_centroids();
}

space::CentroidCells space::fit_volumes_and_centroids(const Lattice& /*lattice*/,
                                                      const Points& /*centroids*/,
                                                      const VolumeCvtOptions& /*options*/) {
    refuse_centroids();
}

space::Grains space::mesh_grains(const Sites& /*sites*/, const CellComplex& /*complex*/,
                                 const GrainChoices& /*choices*/, Workers& /*workers*/,
                                 const Vec3& /*origin*/) {
    throw InvalidInput("this module has no tetrahedra inside of cells; take the command");
}

space::CellComplex space::cells_in_box(const Sites& /*sites*/, const CellComplex& /*complex*/,
                                       const Vec3& /*origin*/, double /*snapped*/) {
    throw InvalidInput("this module cuts no cells of space at a box; take the command");
}

space::Vec3 space::best_box_origin(const Sites& /*sites*/, const CellComplex& /*complex*/) {
    throw InvalidInput("this module cuts no cells of space at a box; take the command");
}

// Only tiles of cells_in_box() have sides.
void space::put_on_sides(const Vec3& /*origin*/, PolyhedralMesh& /*mesh*/) {}
void space::put_on_sides(const Vec3& /*origin*/, TetrahedralMesh& /*mesh*/) {}

}  // namespace pcvt
