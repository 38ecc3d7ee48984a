#include "plugin/checks/area_check.hpp"

#include <cmath>
#include <functional>
#include <limits>

#include "io/bytes/readable_number.hpp"
#include "mesher/cells/target_areas.hpp"
#include "mesher/plane/cvt/cell_areas.hpp"
#include "mesher/plane/geometry/face_polygon.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::checks {
namespace {

/// The cells of a tile with weights, as its file states them.
plane::StatedCells stated_cells(const TileFile& file, const plane::TileProof& proof) {
    const plane::Tile& tile = file.tile;
    const auto n = static_cast<int>(tile.site_positions.size());
    plane::StatedCells cells{
        .lattice = plane::Lattice(tile.lattice.a() / tile.columns, tile.lattice.b() / tile.rows),
        .metric = tile.metric,
        .walls = tile.walls,
        .points = plane::Points(2, n),
        .weights = Eigen::Map<const Eigen::VectorXd>(tile.site_weights.data(), n),
        .rounding = proof.tolerance,
        .weight_rounding = file.precision == plane::Precision::kDouble
                               ? std::numeric_limits<double>::epsilon()
                               : double(std::numeric_limits<float>::epsilon())};
    for (int s = 0; s < n; ++s) cells.points.col(s) = tile.site_positions[s];
    return cells;
}

/// The cells of voxels with weights. Positions are rounded as in tiles.
plane::StatedCells stated_cells(const plane::VoxelCells& cells) {
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
bool moves_corners(const plane::Tile& tile) {
    return tile.kind == plane::MeshKind::kGrains ||
           (tile.kind == plane::MeshKind::kVoronoi && tile.short_edges > 0);
}

/// Compares the areas of the faces of each site with the target areas.
plane::AreaComparison compare_face_areas(const plane::Tile& tile, const plane::TileProof& proof,
                                         const Eigen::VectorXd& wanted) {
    Eigen::VectorXd area = Eigen::VectorXd::Zero(wanted.size());
    Eigen::VectorXd perimeter = area;
    for (int f = 0; f < tile.n_faces(); ++f) {
        const plane::Polygon polygon = plane::face_polygon(tile.points, tile.faces[f]);
        area[tile.face_site[f]] += plane::polygon_area(polygon) / (tile.columns * tile.rows);
        perimeter[tile.face_site[f]] +=
            plane::polygon_perimeter(polygon) / (tile.columns * tile.rows);
    }
    plane::AreaComparison worst{.site = -1, .area = 0, .error = 0, .tolerance = 0};
    const double least =
        plane::file_area_tolerance(static_cast<int>(wanted.size()) * n_images(tile.walls));
    for (int s = 0; s < wanted.size(); ++s) {
        const double error = std::abs(area[s] - wanted[s]) / wanted[s];
        const double tolerance = std::max(least, perimeter[s] * proof.tolerance / wanted[s]);
        if (worst.site >= 0 && error * worst.tolerance <= worst.error * tolerance) continue;
        worst = {.site = s, .area = area[s], .error = error, .tolerance = tolerance};
    }
    return worst;
}

[[noreturn]] void refuse_without_weights(const std::string& path) {
    throw UnusableFile(path +
                       ": states no weights of its sites, so it has no power cells; check it "
                       "without --areas");
}

/// Compares the areas of n cells with the target areas.
/// @param compare  measures the cells and compares them with areas in units of the domain.
std::string prove_areas(
    const AreaFile& wanted, int n, double domain_area,
    const std::function<plane::AreaComparison(const Eigen::VectorXd&)>& compare) {
    try {
        require_areas(wanted, n);
    } catch (const BadFile& error) {
        throw UnusableFile(error.what());  // The table does not fit; the tile may be right.
    }
    const Eigen::VectorXd areas = scaled_areas(wanted.areas, n, domain_area);
    const plane::AreaComparison found = compare(areas);
    const std::string text =
        figure(found.error) + " of " + wanted.name + " (tolerance " + figure(found.tolerance) + ")";
    if (found.error <= found.tolerance) {
        return ", areas of " + std::to_string(n) + " cells within " + text;
    }
    throw NotATile("law of the areas: the cell of site " + std::to_string(found.site) +
                   " has the area " + figure(found.area) + ", not " + figure(areas[found.site]) +
                   ": off by " + text);
}

}  // namespace

std::string prove_tile_areas(const std::string& path, const TileFile& file,
                             const plane::TileProof& proof, const AreaFile& wanted) {
    if (file.tile.site_weights.empty()) refuse_without_weights(path);
    const plane::StatedCells cells = stated_cells(file, proof);
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
    const plane::StatedCells cells = stated_cells(*file.cells);
    return prove_areas(wanted, static_cast<int>(cells.points.cols()), cells.lattice.area(),
                       [&](const Eigen::VectorXd& areas) { return compare_areas(cells, areas); });
}

}  // namespace pcvt::checks
