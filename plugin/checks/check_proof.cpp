#include "plugin/checks/check_proof.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "io/bytes/input_file.hpp"
#include "io/bytes/readable_number.hpp"
#include "io/formats/file_proof.hpp"
#include "io/formats/formats.hpp"
#include "io/formats/output_files.hpp"
#include "io/formats/space_format.hpp"
#include "io/gltf/gltf_place.hpp"
#include "io/outputs/recovery.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/plane/density/density_centroid.hpp"
#include "mesher/plane/proof/validate_voronoi.hpp"
#include "plugin/checks/area_check.hpp"
#include "plugin/checks/inclusion_check.hpp"
#include "plugin/checks/space_check.hpp"
#include "plugin/checks/tolerance_check.hpp"
#include "plugin/checks/volume_check.hpp"

namespace pcvt::checks {
namespace {

const Format& readable_format(const std::string& path) {
    const Format* format = find_format(path);
    if (format == nullptr || !format->is_readable()) {
        throw UnusableFile(path + ": not a format that is read back; give one of " +
                           readable_extensions());
    }
    return *format;
}

/// The file, and those of its companions that are beside it.
std::vector<EncodedFile> read_files(const Format& format, const std::string& path) {
    const std::vector<std::string> paths = format.paths(path);
    std::vector<EncodedFile> files;  // a list in braces would be copied
    files.push_back({paths[0], read_whole_file(paths[0])});
    for (std::size_t p = 1; p < paths.size(); ++p) {
        // A companion that cannot be examined exists for all that is known; its reader says why.
        std::error_code unknown;
        if (std::filesystem::exists(paths[p], unknown) || unknown) {
            files.push_back({paths[p], read_whole_file(paths[p])});
        }
    }
    return files;
}

void compare_lattice(const plane::Lattice& stated, const plane::Lattice& asked) {
    if (stated.a() == asked.a() && stated.b() == asked.b()) return;
    throw NotATile("the file states the lattice " + figure(stated.a().x()) + "," +
                   figure(stated.a().y()) + "," + figure(stated.b().x()) + "," +
                   figure(stated.b().y()) + ", not the one that was given");
}

/// The tolerance for a file: in single precision, not below the rounding.
double resolved(const TileFile& file, const plane::TileProof& proof, double tolerance) {
    if (file.precision == plane::Precision::kDouble) return tolerance;
    // Three cells meet at a vertex, so there are two vertices a cell; files may hold cells in
    // parts.
    const double n =
        file.tile.kind == plane::MeshKind::kVoronoi ? proof.n_orbits / 2.0 : proof.n_orbits;
    return std::max(tolerance, 2 * proof.tolerance / std::sqrt(file.tile.lattice.area() / n));
}

double prove_voronoi(const TileFile& file, const plane::TileProof& proof, const Question& question,
                     double tolerance) {
    if (!question.density) return prove_voronoi(file.tile, proof, tolerance);
    const plane::Lattice& lattice = file.tile.lattice;
    const plane::Density density = question.density(lattice);
    const plane::CellQuadrature quadrature(density);
    plane::DensityProbe probe(lattice, density.make_function());
    return prove_voronoi(file.tile, proof, tolerance, [&](const plane::Polygon& polygon) {
        return density_centroid(lattice, quadrature, polygon, probe);
    });
}

std::string prove_cvt(const TileFile& file, const plane::TileProof& proof,
                      const Question& question) {
    const bool cells = file.tile.kind == plane::MeshKind::kVoronoi;
    const double tolerance = resolved(file, proof, *question.cvt_tolerance);
    const double found = prove_voronoi(file, proof, question, tolerance);
    const bool weighted = !file.tile.site_weights.empty();
    const char* const property = cells
                                     ? (weighted ? "centroidal power cells" : "centroidal Voronoi")
                                     : (weighted ? "regular" : "Delaunay");
    return std::string(", ") + property + " within " + figure(found) + " h (tolerance " +
           figure(tolerance) + " h)";
}

/// A tile with these walls, as lines of proof and refutation name it.
std::string content_of(Walls walls) {
    if (walls == Walls::kNone) return "a periodic tile";
    return walls == Walls::kXY ? "a box with four walls" : "a channel";
}

/// The same with the direction of a channel and its walls.
std::string described(Walls walls) {
    if (walls == Walls::kNone || walls == Walls::kXY) return content_of(walls) + ": ";
    const bool across_x = walls == Walls::kX;
    const auto word = [](WallSide side) { return std::string(wall_side_row(side).word); };
    return content_of(walls) + ": periodic along " + (across_x ? "y" : "x") + ", walls " +
           word(across_x ? WallSide::kLeft : WallSide::kBottom) + " and " +
           word(across_x ? WallSide::kRight : WallSide::kTop) + ", ";
}

/// What the tile becomes when its seam is glued.
std::string glued_text(const plane::Tile& tile, const plane::TileProof& proof) {
    const auto on_holes =
        std::count_if(proof.wall_edges.begin(), proof.wall_edges.end(),
                      [](const plane::WallEdge& edge) { return edge.wall.is_hole(); });
    const auto on_walls = static_cast<std::ptrdiff_t>(proof.wall_edges.size()) - on_holes;
    std::string text;
    if (tile.walls != Walls::kNone) text += std::to_string(on_walls) + " on walls, ";
    if (!tile.holes.empty()) text += std::to_string(on_holes) + " on holes, ";
    const char* const filling = tile.holes.empty() ? "" : " and filling";
    switch (tile.walls) {
        case Walls::kNone:
            return text + "genus 1 after gluing" + filling;
        case Walls::kXY:
            return text + "a disc" + (tile.holes.empty() ? "" : " after filling");
        default:
            return text + "an annulus after gluing" + filling;
    }
}

std::string pairs_text(const TileFile& file) {
    if (file.has_edge_pairs) return ", stored pairs agree";
    return file.has_vertex_pairs ? ", stored vertex pairs agree" : ", no pairs stored";
}

/// The kind of the cells. Where corners were moved, and of triangles, it is stated only.
std::string shape_text(const plane::Tile& tile) {
    std::string text;
    if (!tile.site_weights.empty()) text += ", power cells";
    if (!tile.metric.is_round()) {
        text += ", elongated " + figure(tile.metric.ratio()) + ":1 at " +
                figure(tile.metric.degrees()) + " degrees";
    }
    const bool proved = tile.kind == plane::MeshKind::kVoronoi && !(tile.short_edges > 0);
    return proved || text.empty() ? text : text + " as stated";
}

/// The part of the line about the site ids.
std::string sites_text(const plane::Tile& tile) {
    if (tile.sites().empty()) return ", no sites stored";
    if (tile.site_positions.empty()) return ", site ids complete, no positions of sites stored";
    return ", " + std::to_string(tile.site_positions.size()) + " sites agree" + shape_text(tile);
}

std::string orbits_text(const std::vector<int>& orbits) {
    if (orbits.empty()) return "";
    const int n = 1 + *std::max_element(orbits.begin(), orbits.end());
    return ", " + std::to_string(n) + " orbits agree";
}

/// Requires that a property is not to be proved of a file that cannot have it.
void refuse_where(bool is_asked, const std::string& path, const char* fault) {
    if (is_asked) throw UnusableFile(path + ": " + fault);
}

void refuse_volumes(const std::string& path, const Question& question) {
    refuse_where(question.volumes.has_value(), path,
                 "--volumes is for cells in space, and the file holds cells in the plane; take "
                 "--areas");
}

/// The proof of an MPAS file as a line.
std::string prove_grid(GridReader* read, const Format& format, const std::string& path,
                       const Question& question) {
    refuse_where(question.cvt_tolerance.has_value(), path,
                 "--cvt is not for MPAS files; check a tile of the same run");
    refuse_where(question.areas.has_value(), path,
                 "--areas is not for MPAS files, which have no power cells");
    refuse_volumes(path, question);
    refuse_where(question.inclusions.has_value(), path,
                 "--inclusions is not for MPAS files; check a tile of the same run");
    refuse_where(question.tolerance > 0, path, "--tolerance is not for MPAS files; leave it out");
    const std::vector<EncodedFile> files = read_files(format, path);
    const MpasGrid grid = read(files);
    if (question.lattice) {
        compare_lattice(plane::Lattice::rectangle(grid.x_period, grid.y_period), *question.lattice);
    }
    const MpasGridProof proof = prove_grid(files, grid);
    return path + ": an MPAS mesh: " + std::to_string(grid.n_cells) + " cells, " +
           std::to_string(grid.n_edges) + " edges, " + std::to_string(grid.n_vertices) +
           " vertices, period " + figure(grid.x_period) + " x " + figure(grid.y_period) +
           ", lengths and angles within " + figure(proof.geometry) + " h, areas within " +
           figure(proof.areas) + ", TRiSK identity within " + figure(proof.trisk) + "\n";
}

/// The cells that are smaller than a voxel, at most some of them.
std::string unseen_text(const std::vector<SiteId>& unseen) {
    if (unseen.empty()) return "every cell has voxels";
    constexpr std::size_t kMostNamed = 8;
    std::string text = std::to_string(unseen.size()) + " cells contain the centre of no voxel (";
    for (std::size_t k = 0; k < std::min(unseen.size(), kMostNamed); ++k) {
        text += (k == 0 ? "" : " ") + std::to_string(unseen[k]);
    }
    return text + (unseen.size() > kMostNamed ? " ...)" : ")");
}

/// The verdict on the voxels, in the plane or in space.
std::string voxel_verdict(const VoxelProof& proof, const VoxelFile& file, bool has_sites) {
    return (has_sites ? ", each voxel in the cell of its site within " +
                            figure(proof.largest_excess) + " h"
                      : ", no sites stored") +
           (file.materials ? ", one material a cell" : ", no materials beside it") + ", " +
           unseen_text(proof.unseen);
}

/// The proof of voxels in space, behind the path.
std::string space_voxels_text(const std::string& path, const std::vector<EncodedFile>& files,
                              const VoxelFile& file, const Question& question) {
    if (question.lattice || question.areas) {
        throw BadFile(path +
                      ": holds voxels in space, which state their lattice and have no areas; leave "
                      "the options out, or take --volumes");
    }
    const VoxelProof proof = prove_voxel_file(files, file);
    const space::VoxelGrid& grid = file.space->image.grid;
    return std::to_string(grid.counts.x) + " x " + std::to_string(grid.counts.y) + " x " +
           std::to_string(grid.counts.z) + " voxels of " + std::to_string(proof.n_cells) +
           " cells, period " + figure(grid.size.x()) + " x " + figure(grid.size.y()) + " x " +
           figure(grid.size.z()) + voxel_verdict(proof, file, file.space->cells.has_value()) +
           (question.volumes ? prove_voxel_volumes(path, *file.space, *question.volumes) : "");
}

/// The proof of a voxel image as a line.
std::string prove_voxel_image(VoxelReader* read, const Format& format, const std::string& path,
                              const Question& question) {
    refuse_where(question.cvt_tolerance.has_value(), path,
                 "--cvt is not for voxels; check a tile of the same run");
    refuse_where(question.inclusions.has_value(), path,
                 "--inclusions is not for voxels; check a tile of the same run");
    refuse_where(question.tolerance > 0, path, "--tolerance is not for voxels; leave it out");
    const std::vector<EncodedFile> files = read_files(format, path);
    const VoxelFile file = read(files);
    if (file.space) {
        return path + ": a voxel image: " + space_voxels_text(path, files, file, question) + "\n";
    }
    refuse_volumes(path, question);
    const plane::VoxelGrid& grid = file.image.grid;
    if (question.lattice) {
        compare_lattice(plane::Lattice::rectangle(grid.size.x(), grid.size.y()), *question.lattice);
    }
    const VoxelProof proof = prove_voxel_file(files, file);
    return path + ": a voxel image: " + std::to_string(grid.counts.x) + " x " +
           std::to_string(grid.counts.y) +
           (grid.counts.z > 1 ? " x " + std::to_string(grid.counts.z) + " equal layers of" : "") +
           " voxels of " + std::to_string(proof.n_cells) + " cells, period " +
           figure(grid.size.x()) + " x " + figure(grid.size.y()) +
           voxel_verdict(proof, file, file.cells.has_value()) +
           (question.areas ? prove_voxel_areas(path, file, *question.areas) : "") + "\n";
}

/// The proof of a tile in space as a line.
std::string prove_tile_in_space(const std::string& path, const std::vector<EncodedFile>& files,
                                const Question& question) {
    const bool of_the_plane =
        question.lattice || question.areas || question.inclusions || question.density;
    if (of_the_plane) {
        throw UnusableFile(
            path +
            ": holds a tile in space, which states its lattice and is proved without further "
            "options but --cvt, --volumes and --tolerance; leave the others out");
    }
    return prove_space_tile(path, files, question);
}

/// As prove_file().
/// @throws NotATile  also with the tolerance that would suffice.
plane::TileProof prove_seam_and_fields(const Format& format, const std::vector<EncodedFile>& files,
                                       const TileFile& file) {
    try {
        return prove_file(format, files, file);
    } catch (const SeamMismatch& fault) {
        TileFile wider = file;
        throw NotATile(fault.what() + tolerance_advice(fault, [&](double tolerance) {
                           wider.tolerance = tolerance;
                           return prove_tile_file(wider).mismatch;
                       }));
    }
}

/// The verdict on the seam.
std::string seam_text(const plane::TileProof& proof) {
    std::string text = std::to_string(proof.n_boundary_edges) + " boundary edges in " +
                       std::to_string(proof.edge_pairs.size()) + " pairs, ";
    if (proof.edge_pairs.empty()) return text;
    return text + "periodic within " + in_words(proof.mismatch) + ", ";
}

/// The proof of a tile as a line.
/// @param content  becomes the thing that the file states to be.
std::string prove_one_tile(const Format& format, const std::string& path, const Question& question,
                           std::string& content) {
    const std::vector<EncodedFile> files = read_files(format, path);
    if (const std::optional<SpaceFileKind> kind = space_file_kind(files)) {
        content = space_content_text(*kind);
        return prove_tile_in_space(path, files, question);
    }
    refuse_volumes(path, question);
    TileFile file = decode_tile(format, files, question.lattice);
    file.tolerance = question.tolerance;
    content = content_of(file.tile.walls);
    if (question.lattice) compare_lattice(file.tile.lattice, *question.lattice);
    const plane::TileProof proof = prove_seam_and_fields(format, files, file);
    if (file.translation != plane::Vec2::Zero())
        file.tile = moved_by(std::move(file.tile), file.translation);
    std::string line = path + ": " + described(file.tile.walls) + std::to_string(proof.n_vertices) +
                       " vertices, " + std::to_string(proof.n_faces) + " faces, " +
                       seam_text(proof) + glued_text(file.tile, proof) + ", " + "area " +
                       figure(proof.area) + " (tolerance " + figure(proof.tolerance) + "), " +
                       std::to_string(proof.n_merged) + " merged" + pairs_text(file) +
                       sites_text(file.tile) + orbits_text(file.site_orbits);
    if (question.cvt_tolerance) line += prove_cvt(file, proof, question);
    if (question.areas) line += prove_tile_areas(path, file, proof, *question.areas);
    if (question.inclusions) line += prove_inclusions(path, file, proof, *question.inclusions);
    return line + "\n";
}

}  // namespace

std::string prove(const std::string& path, const Question& question) {
    const Format& format = readable_format(path);
    if (const std::optional<std::string> journal = unfinished_set_of(format.paths(path))) {
        throw UnusableFile(path + ": a run ended before it had written all files of its set (" +
                           *journal + "); run pcvt again in that folder, which finishes the set");
    }
    std::string content = format.reads_voxels() ? "a voxel image"
                          : format.reads_grid() ? "an MPAS mesh"
                                                : content_of(Walls::kNone);
    try {
        if (const auto* read = std::get_if<GridReader*>(&format.read)) {
            return prove_grid(*read, format, path, question);
        }
        if (const auto* read = std::get_if<VoxelReader*>(&format.read)) {
            return prove_voxel_image(*read, format, path, question);
        }
        return prove_one_tile(format, path, question, content);
    } catch (const NotATile& error) {
        throw NotATile(path + ": not " + content + ": " + error.what());
    }
}

}  // namespace pcvt::checks
