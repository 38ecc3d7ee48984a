#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/formats/format_choices.hpp"
#include "io/forms/file_options.hpp"
#include "io/forms/file_tetrahedra.hpp"
#include "io/forms/space_tile.hpp"
#include "io/forms/surface_list.hpp"
#include "io/voxels/vti_writer.hpp"
#include "mesher/plane/mesh/mesh_kind.hpp"

namespace pcvt {

/// The content of a file of a tile in space: its cells, its tetrahedra, its boundary, the
/// triangles of either of the first and the last in single precision, or only closed surfaces.
enum class SpaceFileKind { kPolyhedra, kTetrahedra, kBoundary, kTriangles, kClosedSurfaces };

/// Whether a format holds surfaces: none, those of the cells or the boundary as
/// FileOptions::surfaces chooses, or always the boundary.
enum class FormatSurfaces { kNone, kChosen, kBoundary };

/// The list of only `path`.
std::vector<std::string> single_path(const std::string& path);

/// Writes the cells as voxels, with the phases, orientations and elastic constants of the cells.
using SpaceVoxelWriter = std::vector<EncodedFile>(const space::VoxelImage& image,
                                                  const space::VoxelCells& cells,
                                                  const CellMaterials& materials,
                                                  const ElasticChoices& elastic,
                                                  const std::string& path);

/// The part of a tile in space that a format holds: volumes, their surfaces, their sites, or their
/// voxels.
struct SpaceFormat {
    FormatSurfaces surfaces = FormatSurfaces::kNone;
    /// The memory of a run that writes one such file, bytes a site. Measured at 2e4 to 5e5 random
    /// sites, whose cells have the most faces: the largest of several runs, because the peak of
    /// equal runs with two threads differs by a sixth.
    double memory;
    /// The choices that the format takes for a tile in space.
    FormatChoices takes = {};
    /// The files of the output with this path, which encode() returns in this order.
    std::vector<std::string> (*paths)(const std::string& path) = single_path;
    /// Encodes a tile of polyhedra, and of tetrahedra; both null: the file holds the sites,
    /// a table of the cells, or voxels.
    std::vector<EncodedFile> (*encode)(const SpaceTile& tile, const FileOptions& options,
                                       const std::string& path) = nullptr;
    std::vector<EncodedFile> (*encode_tetrahedra)(const space::TetrahedralMesh& mesh,
                                                  const FileOptions& options,
                                                  const std::string& path) = nullptr;
    /// Encodes the cells as voxels of a box; null: the format holds none.
    SpaceVoxelWriter* encode_voxels = nullptr;
    /// Returns the kind of files of this extension, as `pcvt check` reads them; nothing if they do
    /// not hold a tile in space. Null for pictures, sites, tables and voxels.
    std::optional<SpaceFileKind> (*kind)(const std::vector<EncodedFile>& files) = nullptr;
    /// Reads tetrahedra, and compares all other statements of the file with the values that follow
    /// from them. Set if and only if encode_tetrahedra is set and files are not closed surfaces.
    TetrahedralTile (*decode_tetrahedra)(const std::vector<EncodedFile>& files,
                                         double tolerance) = nullptr;
    void (*compare_tetrahedra)(const std::vector<EncodedFile>& files, const TetrahedralTile& tile,
                               double tolerance) = nullptr;
    /// Whether it holds only tetrahedra inside of cells.
    bool holds_only_grains = false;
    /// Whether it states the four corners of tetrahedra without their order.
    bool sorts_corners = false;
    /// Whether its files hold closed surfaces and nothing else, whose proof needs no sites.
    bool is_closed_surfaces = false;
    /// Whether its cells state their materials.
    bool states_materials = false;
    /// Whether its coordinates are rounded to the width that solvers read.
    bool rounds_positions = false;
    /// Whether its cells state SpaceTile::weights and PolyhedralMesh::metric, without which power
    /// cells and elongated cells are not proved.
    bool states_weights = false;
    /// Whether its cells state PolyhedralMesh::metric, without which elongated cells are not
    /// proved.
    bool states_metric = false;
    /// Whether its cells state PolyhedralMesh::short_edges, without which no tile is proved that
    /// lost edges.
    bool states_short_edges = false;

    /// Whether its files hold the tetrahedra, of a job with this mesh.
    bool shows_tetrahedra(plane::MeshKind mesh) const {
        if (mesh == plane::MeshKind::kDelaunay && holds_only_grains) return false;
        return encode_tetrahedra != nullptr &&
               (encode == nullptr || mesh != plane::MeshKind::kVoronoi);
    }
    /// Whether its files are written and never read back.
    bool is_picture() const { return encode != nullptr && kind == nullptr; }
    /// Whether no proof of its files needs to know how the cells belong to their sites.
    bool is_free_of_sites() const {
        return encode == nullptr || is_picture() || is_closed_surfaces;
    }
    /// Whether it takes a tile that lost edges: a picture, a list of sites, tetrahedra inside of
    /// cells, or cells that state it.
    bool takes_short_edges(plane::MeshKind mesh) const {
        if (shows_tetrahedra(mesh)) return mesh == plane::MeshKind::kGrains;
        return states_short_edges || is_free_of_sites();
    }
    /// Whether it takes power cells: a picture, a table or a list of sites, tetrahedra inside of
    /// cells, or cells that state their weights.
    bool takes_weights(plane::MeshKind mesh) const {
        if (shows_tetrahedra(mesh)) return mesh == plane::MeshKind::kGrains;
        return states_weights || is_free_of_sites();
    }
    /// Whether it takes elongated cells: a picture, a table or a list of sites, tetrahedra, or
    /// cells that state their metric.
    bool takes_metric(plane::MeshKind mesh) const {
        return shows_tetrahedra(mesh) || states_metric || is_free_of_sites();
    }
    bool shows_boundary(SurfaceForm chosen) const {
        return surfaces == FormatSurfaces::kBoundary ||
               (surfaces == FormatSurfaces::kChosen && chosen == SurfaceForm::kBoundary);
    }
};

}  // namespace pcvt
