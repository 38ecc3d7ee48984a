#include "io/formats/file_proof.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "io/bytes/output_error.hpp"
#include "io/bytes/text.hpp"
#include "io/forms/site_notes.hpp"
#include "io/gltf/gltf_place.hpp"
#include "io/mpas/mpas_graph.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "mesher/plane/proof/site_labels.hpp"
#include "mesher/plane/tile/site_positions.hpp"
#include "mesher/plane/tile/tile_equality.hpp"

namespace pcvt {
namespace {

std::vector<plane::EdgePair> sorted(std::vector<plane::EdgePair> pairs) {
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// Whether every law of a tile says the same of both: the proof of the one is that of the other.
bool is_the_same(const TileFile& file, const plane::Tile& proved) {
    return file.precision == plane::Precision::kDouble && same_geometry(file.tile, proved) &&
           same_site_notes(file.tile, proved) &&
           (!file.has_vertex_pairs || file.tile.vertex_pairs == proved.vertex_pairs) &&
           (!file.has_edge_pairs || sorted(file.tile.edge_pairs) == sorted(proved.edge_pairs)) &&
           (!file.has_wall_edges || file.tile.wall_edges == proved.wall_edges);
}

/// The groups of a file are those of its sites.
void require_sites(const std::string& path, const plane::Tile& tile) {
    if (!tile.sites().empty()) return;
    throw BadFile(path + ": lacks the sites; write the file again with pcvt");
}

/// The path for which the format's writer gives `files`: that of the first one, or its folder.
std::string path_of(const Format& format, const std::vector<EncodedFile>& files) {
    const std::string& path = files.front().path;
    if (!format.is_folder) return path;
    return path.substr(0, path.size() - format.paths("").front().size());
}

/// A tile whose laws, stored pairs and site ids are proved, and the cells of its faces.
struct ProvedLabels {
    plane::TileProof proof;
    plane::FaceImages cells;
};

ProvedLabels prove_labels(const TileFile& file) {
    plane::TileProof proof = prove_tile(file.tile, file.precision, file.tolerance);
    if (file.has_vertex_pairs) compare_vertex_pairs(file.tile, proof);
    if (file.has_edge_pairs) compare_edge_pairs(file.tile, proof);
    if (file.has_wall_edges || !file.tile.holes.empty()) compare_wall_edges(file.tile, proof);
    plane::FaceImages cells = prove_sites(file.tile, proof);
    return {std::move(proof), std::move(cells)};
}

/// Compares the files with those that the writer gives for their tile, unless they are these.
void prove_fields(const Format& format, const std::vector<EncodedFile>& files, const TileFile& file,
                  const ProvedLabels& proved) {
    FileOptions options{.materials = file.materials.empty() ? nullptr : &file.materials,
                        .site_orbits = file.site_orbits,
                        .thickness = file.thickness};
    if (file.thickness > 0) options.element = wedge_element(file.tile.order);
    plane::Tile tile = file.tile;
    tile.vertex_pairs = proved.proof.vertex_pairs;
    tile.edge_pairs = proved.proof.edge_pairs;
    tile.wall_edges = proved.proof.wall_edges;
    tile.grain_site_points = grain_site_points(tile, proved.cells.of_face);
    if (format.holds_sites) require_sites(files.front().path, tile);
    compare_files(files, encode_tile(format, tile, path_of(format, files), options), format.fields);
}

/// The part of the materials that a format states.
CellMaterials held_materials(const Format& format, const FileOptions& options) {
    if (!format.states_materials || options.materials == nullptr) return {};
    CellMaterials materials = *options.materials;
    if (!format.takes.orientations) materials.site_orientation.clear();
    return materials;
}

/// Whether a file has the orbits of its sites, as far as these have elements.
bool has_orbits(const Format& format, const TileFile& file, const FileOptions& options) {
    const std::vector<int>& found = file.site_orbits;
    if (!format.states_orbits || options.site_orbits.empty()) return found.empty();
    return !found.empty() && found.size() <= options.site_orbits.size() &&
           std::equal(found.begin(), found.end(), options.site_orbits.begin(),
                      [](int orbit, int wanted) { return orbit == -1 || orbit == wanted; });
}

/// Throws CoarsePrecision if the format stores the tile in single precision, which does not resolve
/// it.
void refuse_coarse_precision(const Format& format, const std::string& path, const plane::Tile& tile,
                             const plane::Vec2& origin, const FileOptions& options) {
    if (!format.holds_single_precision(options)) return;
    const plane::Vec2 from =
        format.moves_distant_tiles ? gltf_translation(tile) : plane::Vec2::Zero();
    if (fits_single_precision(tile, from)) return;
    throw CoarsePrecision(path + ": the format's single precision is too coarse for this tile; " +
                          "take another format" +
                          (origin == plane::Vec2::Zero() ? "" : ", or an origin nearer to 0,0"));
}

}  // namespace

plane::TileProof prove_tile_file(const TileFile& file) { return prove_labels(file).proof; }

plane::TileProof prove_file(const Format& format, const std::vector<EncodedFile>& files,
                            const TileFile& file) {
    const ProvedLabels proved = prove_labels(file);
    if (!file.site_orbits.empty()) prove_orbit_areas(file.tile, proved.proof, file.site_orbits);
    const bool exact = file.states_lattice && file.precision == plane::Precision::kDouble;
    if (exact && format.fields != nullptr && proved.cells.are_clear) {
        prove_fields(format, files, file, proved);
    }
    return proved.proof;
}

void prove_tile_files(const Format& format, const std::vector<EncodedFile>& files,
                      const plane::Tile& original, const plane::Vec2& origin,
                      const FileOptions& options) {
    const std::string& path = files.front().path;
    try {
        const TileFile file = decode_tile(format, files, std::nullopt);
        if (file.materials != held_materials(format, options)) {
            throw BadFile(path + ": the phases and orientations are others");
        }
        if (!has_orbits(format, file, options)) {
            throw BadFile(path + ": the orbits of the sites are others");
        }
        if (format.holds_thickness(options) && options.thickness > 0 &&
            file.thickness != options.thickness) {
            throw BadFile(path + ": the thickness is another");
        }
        if (!is_the_same(file, original)) prove_file(format, files, file);
    } catch (const NotATile& error) {
        refuse_coarse_precision(format, path, original, origin, options);
        throw InternalError(path + " breaks a law of tiles: " + error.what());
    } catch (const BadFile& error) {
        refuse_coarse_precision(format, path, original, origin, options);
        throw InternalError(std::string("a file is not read back: ") + error.what());
    }
}

MpasGridProof prove_grid(const std::vector<EncodedFile>& files, const MpasGrid& grid) {
    const MpasGridProof proof = prove_mpas_grid(grid);
    for (std::size_t k = 1; k < files.size(); ++k) {
        compare_mpas_graph(grid, files[k].path, files[k].bytes);
    }
    return proof;
}

void prove_grid_files(const Format& format, const std::vector<EncodedFile>& files) {
    try {
        prove_grid(files, std::get<GridReader*>(format.read)(files));
    } catch (const InvalidInput& error) {
        throw InternalError(files.front().path + " breaks a law of C-grids: " + error.what());
    }
}

void prove_voxel_files(const Format& format, const std::vector<EncodedFile>& files,
                       const CellMaterials& materials) {
    try {
        const VoxelFile file = std::get<VoxelReader*>(format.read)(files);
        const VoxelProof proof = prove_voxel_file(files, file);
        compare_damask_material(files[1].path, file.materials.value(), proof.n_cells, materials);
    } catch (const InvalidInput& error) {
        throw InternalError(files.front().path + " breaks a law of voxels: " + error.what());
    }
}

void prove_site_files(const Format& format, const std::vector<EncodedFile>& files,
                      const plane::Points& sites) {
    if (std::get<SiteReader*>(format.read)(files, sites)) return;
    throw InternalError(files.front().path + ": other sites are read back than were written");
}

void prove_cell_files(const Format& format, const std::vector<EncodedFile>& files,
                      const CellRows& rows) {
    try {
        if (std::get<CellReader*>(format.read)(files, rows)) return;
    } catch (const BadFile& error) {
        throw InternalError(std::string("a file is not read back: ") + error.what());
    }
    throw InternalError(files.front().path + ": other cells are read back than were written");
}

}  // namespace pcvt
