#include "plugin/cli/check_proof.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "io/file_proof.hpp"
#include "io/outputs/recovery.hpp"
#include "io/tile_formats.hpp"
#include "mesher/areas/cell_areas.hpp"
#include "mesher/areas/target_areas.hpp"
#include "mesher/density/density_centroid.hpp"
#include "mesher/lattice/polygon.hpp"
#include "mesher/proof/validate_voronoi.hpp"
#include "plugin/cli/cell_options.hpp"
#include "plugin/cli/terminal/console.hpp"
#include "plugin/job/job_files.hpp"

namespace pcvt::cli {
namespace {

const TileFormat& readable_format(const std::string& path) {
    const TileFormat* format = find_tile_format(path);
    if (format == nullptr || !format->is_readable()) {
        throw BadFile(path + ": not a format that is read back; give one of " +
                      readable_extensions());
    }
    return *format;
}

/// The file, and those of its companions that are beside it.
std::vector<EncodedFile> read_files(const TileFormat& format, const std::string& path) {
    const std::vector<std::string> paths = format.paths(path);
    std::vector<EncodedFile> files = {{paths[0], read_whole_file(paths[0])}};
    for (std::size_t p = 1; p < paths.size(); ++p) {
        // A companion that cannot be examined exists for all that is known; its reader says why.
        std::error_code unknown;
        if (std::filesystem::exists(paths[p], unknown) || unknown) {
            files.push_back({paths[p], read_whole_file(paths[p])});
        }
    }
    return files;
}

void compare_lattice(const Lattice& stated, const Lattice& asked) {
    if (stated.a() == asked.a() && stated.b() == asked.b()) return;
    throw NotATile("the file states the lattice " + figure(stated.a().x()) + "," +
                   figure(stated.a().y()) + "," + figure(stated.b().x()) + "," +
                   figure(stated.b().y()) + ", not the one that was given");
}

/// The tolerance for a file: in single precision, not below the rounding.
double resolved(const TileFile& file, const TileProof& proof, double tolerance) {
    if (file.precision == Precision::kDouble) return tolerance;
    // Three cells meet at a vertex, so there are two vertices a cell; files may hold cells in
    // parts.
    const double n = file.tile.kind == MeshKind::kVoronoi ? proof.n_orbits / 2.0 : proof.n_orbits;
    return std::max(tolerance, 2 * proof.tolerance / std::sqrt(file.tile.lattice.area() / n));
}

double prove_voronoi(const TileFile& file, const TileProof& proof, const Question& question,
                     double tolerance) {
    if (question.density.empty()) return prove_voronoi(file.tile, proof, tolerance);
    const Lattice& lattice = file.tile.lattice;
    const Density density = density_option(question.density, question.density_range, lattice);
    const CellQuadrature quadrature(density);
    DensityProbe probe(lattice, density.make_function());
    return prove_voronoi(file.tile, proof, tolerance, [&](const Polygon& polygon) {
        return density_centroid(lattice, quadrature, polygon, probe);
    });
}

std::string prove_cvt(const TileFile& file, const TileProof& proof, const Question& question) {
    const bool cells = file.tile.kind == MeshKind::kVoronoi;
    const double tolerance = resolved(file, proof, *question.cvt_tolerance);
    const double found = prove_voronoi(file, proof, question, tolerance);
    const bool weighted = !file.tile.site_weights.empty();
    const char* const property = cells
                                     ? (weighted ? "centroidal power cells" : "centroidal Voronoi")
                                     : (weighted ? "regular" : "Delaunay");
    return std::string(", ") + property + " within " + figure(found) + " h (tolerance " +
           figure(tolerance) + " h)";
}

/// The cells of a tile with weights, as its file states them.
StatedCells stated_cells(const TileFile& file, const TileProof& proof) {
    const Tile& tile = file.tile;
    const auto n = static_cast<int>(tile.site_positions.size());
    StatedCells cells{
        .lattice = Lattice(tile.lattice.a() / tile.columns, tile.lattice.b() / tile.rows),
        .metric = tile.metric,
        .walls = tile.walls,
        .points = Points(2, n),
        .weights = Eigen::Map<const Eigen::VectorXd>(tile.site_weights.data(), n),
        .rounding = proof.tolerance,
        .weight_rounding = file.precision == Precision::kDouble
                               ? std::numeric_limits<double>::epsilon()
                               : double(std::numeric_limits<float>::epsilon())};
    for (int s = 0; s < n; ++s) cells.points.col(s) = tile.site_positions[s];
    return cells;
}

/// The cells of voxels with weights. Positions are rounded as in tiles.
StatedCells stated_cells(const VoxelCells& cells) {
    constexpr double kUlps = 4;
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
    return {.lattice = cells.lattice,
            .metric = cells.metric,
            .points = cells.sites,
            .weights = cells.weights,
            .rounding = kUlps * kEpsilon * cells.sites.cwiseAbs().maxCoeff(),
            .weight_rounding = kEpsilon};
}

/// Whether corners of cells may lie off those of the power cells of the stated weights.
bool moves_corners(const Tile& tile) {
    return tile.kind == MeshKind::kGrains ||
           (tile.kind == MeshKind::kVoronoi && tile.short_edges > 0);
}

/// Compares the areas of the faces of each site with the wished ones.
AreaComparison compare_face_areas(const Tile& tile, const TileProof& proof,
                                  const Eigen::VectorXd& wanted) {
    Eigen::VectorXd area = Eigen::VectorXd::Zero(wanted.size());
    Eigen::VectorXd perimeter = area;
    for (int f = 0; f < tile.n_faces(); ++f) {
        Polygon polygon;
        for (const int v : tile.faces[f]) polygon.push_back(tile.points[v]);
        area[tile.face_site[f]] += polygon_area(polygon) / (tile.columns * tile.rows);
        perimeter[tile.face_site[f]] += polygon_perimeter(polygon) / (tile.columns * tile.rows);
    }
    AreaComparison worst{.site = -1, .area = 0, .error = 0, .tolerance = 0};
    const double least =
        file_area_tolerance(static_cast<int>(wanted.size()) * n_images(tile.walls));
    for (int s = 0; s < wanted.size(); ++s) {
        const double error = std::abs(area[s] - wanted[s]) / wanted[s];
        const double tolerance = std::max(least, perimeter[s] * proof.tolerance / wanted[s]);
        if (worst.site >= 0 && error * worst.tolerance <= worst.error * tolerance) continue;
        worst = {.site = s, .area = area[s], .error = error, .tolerance = tolerance};
    }
    return worst;
}

[[noreturn]] void refuse_without_weights(const std::string& path) {
    throw BadFile(path +
                  ": states no weights of its sites, so it has no power cells; check it "
                  "without --areas");
}

/// Compares the areas of n cells with the wished ones.
/// @param compare  measures the cells and compares them with areas in units of the domain.
std::string prove_areas(const AreaFile& wanted, int n, double domain_area,
                        const std::function<AreaComparison(const Eigen::VectorXd&)>& compare) {
    require_areas(wanted, n);
    const Eigen::VectorXd areas = scaled_areas(wanted.areas, n, domain_area);
    const AreaComparison found = compare(areas);
    const std::string text =
        figure(found.error) + " of " + wanted.name + " (tolerance " + figure(found.tolerance) + ")";
    if (found.error <= found.tolerance) {
        return ", areas of " + std::to_string(n) + " cells within " + text;
    }
    throw NotATile("law of the areas: the cell of site " + std::to_string(found.site) +
                   " has the area " + figure(found.area) + ", not " + figure(areas[found.site]) +
                   ": off by " + text);
}

/// Compares the areas of the power cells, built from nothing, or where corners were moved those of
/// the faces.
std::string prove_tile_areas(const std::string& path, const TileFile& file, const TileProof& proof,
                             const AreaFile& wanted) {
    if (file.tile.site_weights.empty()) refuse_without_weights(path);
    const StatedCells cells = stated_cells(file, proof);
    return prove_areas(wanted, static_cast<int>(cells.points.cols()), cells.lattice.area(),
                       [&](const Eigen::VectorXd& areas) {
                           return moves_corners(file.tile)
                                      ? compare_face_areas(file.tile, proof, areas)
                                      : compare_areas(cells, areas);
                       });
}

std::string prove_voxel_areas(const std::string& path, const VoxelFile& file,
                              const AreaFile& wanted) {
    if (!file.cells || file.cells->weights.size() == 0) refuse_without_weights(path);
    const StatedCells cells = stated_cells(*file.cells);
    return prove_areas(wanted, static_cast<int>(cells.points.cols()), cells.lattice.area(),
                       [&](const Eigen::VectorXd& areas) { return compare_areas(cells, areas); });
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
std::string glued_text(const Tile& tile, const TileProof& proof) {
    if (tile.walls == Walls::kNone) return "genus 1 after gluing";
    return std::to_string(proof.wall_edges.size()) + " on walls, " +
           (tile.walls == Walls::kXY ? "a disc" : "an annulus after gluing");
}

std::string pairs_text(const TileFile& file) {
    if (file.has_edge_pairs) return ", stored pairs agree";
    return file.has_vertex_pairs ? ", stored vertex pairs agree" : ", no pairs stored";
}

/// The kind of the cells. Where corners were moved, and of triangles, it is stated only.
std::string shape_text(const Tile& tile) {
    std::string text;
    if (!tile.site_weights.empty()) text += ", power cells";
    if (!tile.metric.is_round()) {
        text += ", elongated " + figure(tile.metric.ratio()) + ":1 at " +
                figure(tile.metric.degrees()) + " degrees";
    }
    const bool proved = tile.kind == MeshKind::kVoronoi && !(tile.short_edges > 0);
    return proved || text.empty() ? text : text + " as stated";
}

/// The part of the line about the site ids.
std::string sites_text(const Tile& tile) {
    if (tile.sites().empty()) return ", no sites stored";
    if (tile.site_positions.empty()) return ", site ids complete, no positions of sites stored";
    return ", " + std::to_string(tile.site_positions.size()) + " sites agree" + shape_text(tile);
}

std::string orbits_text(const std::vector<int>& orbits) {
    if (orbits.empty()) return "";
    const int n = 1 + *std::max_element(orbits.begin(), orbits.end());
    return ", " + std::to_string(n) + " orbits agree";
}

/// The proof of an MPAS file as a line.
std::string prove_grid(GridReader* read, const TileFormat& format, const std::string& path,
                       const Question& question) {
    if (question.cvt_tolerance) {
        throw BadFile(path + ": --cvt is not for MPAS files; check a tile of the same run");
    }
    if (question.areas) {
        throw BadFile(path + ": --areas is not for MPAS files, which have no power cells");
    }
    const std::vector<EncodedFile> files = read_files(format, path);
    const MpasGrid grid = read(files);
    if (question.lattice) {
        compare_lattice(Lattice::rectangle(grid.x_period, grid.y_period), *question.lattice);
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

/// The proof of a voxel image as a line.
std::string prove_voxel_image(VoxelReader* read, const TileFormat& format, const std::string& path,
                              const Question& question) {
    if (question.cvt_tolerance) {
        throw BadFile(path + ": --cvt is not for voxels; check a tile of the same run");
    }
    const std::vector<EncodedFile> files = read_files(format, path);
    const VoxelFile file = read(files);
    const VoxelGrid& grid = file.image.grid;
    if (question.lattice) {
        compare_lattice(Lattice::rectangle(grid.size.x(), grid.size.y()), *question.lattice);
    }
    const VoxelProof proof = prove_voxel_file(files, file);
    return path + ": a voxel image: " + std::to_string(grid.counts.x) + " x " +
           std::to_string(grid.counts.y) + " voxels of " + std::to_string(proof.n_cells) +
           " cells, period " + figure(grid.size.x()) + " x " + figure(grid.size.y()) +
           (file.cells ? ", each voxel in the cell of its site within " +
                             figure(proof.largest_excess) + " h"
                       : ", no sites stored") +
           (file.materials ? ", one material a cell" : ", no materials beside it") + ", " +
           unseen_text(proof.unseen) +
           (question.areas ? prove_voxel_areas(path, file, *question.areas) : "") + "\n";
}

/// The proof of a tile as a line.
/// @param content  becomes the thing that the file states to be.
std::string prove_one_tile(const TileFormat& format, const std::string& path,
                           const Question& question, std::string& content) {
    const std::vector<EncodedFile> files = read_files(format, path);
    const TileFile file = decode_tile(format, files, question.lattice);
    content = content_of(file.tile.walls);
    if (question.lattice) compare_lattice(file.tile.lattice, *question.lattice);
    const TileProof proof = prove_file(format, files, file);
    std::string line = path + ": " + described(file.tile.walls) + std::to_string(proof.n_vertices) +
                       " vertices, " + std::to_string(proof.n_faces) + " faces, " +
                       std::to_string(proof.n_boundary_edges) + " boundary edges in " +
                       std::to_string(proof.edge_pairs.size()) + " pairs, " +
                       glued_text(file.tile, proof) + ", " + "area " + figure(proof.area) +
                       " (tolerance " + figure(proof.tolerance) + "), " +
                       std::to_string(proof.n_merged) + " merged" + pairs_text(file) +
                       sites_text(file.tile) + orbits_text(file.site_orbits);
    if (question.cvt_tolerance) line += prove_cvt(file, proof, question);
    if (question.areas) line += prove_tile_areas(path, file, proof, *question.areas);
    return line + "\n";
}

}  // namespace

std::string prove(const std::string& path, const Question& question) {
    const TileFormat& format = readable_format(path);
    if (const std::optional<std::string> journal = unfinished_set_of(format.paths(path))) {
        throw BadFile(path + ": a run ended before it had written all files of its set (" +
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

}  // namespace pcvt::cli
