#include "mesher/plane/cvt/cell_areas.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/cells/weight_orbits.hpp"
#include "mesher/plane/cvt/area_cvt.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"
#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/power/power_cells.hpp"
#include "mesher/plane/power/power_flips.hpp"
#include "mesher/plane/symmetry/walled_sites.hpp"

namespace pcvt::plane {
namespace {

/// Areas of a file may be off by this many tolerances of a run.
constexpr double kAreaTolerances = 10;

/// Turns a triangulation of the sites into the regular one, certified.
PeriodicDelaunay made_regular(Sites sites, TorusTriangulation triangulation,
                              const Eigen::VectorXd& weights) {
    const Lattice& reduced = sites.reduction().reduced;
    const double unit = gram_unit(reduced);
    const Eigen::VectorXd gram_weights = weights / (unit * unit);
    PowerFlips flips(triangulation, sites.coordinates(), gram_of(reduced), gram_weights);
    if (const auto hidden = flips.run()) {
        throw InvalidInput("site " + std::to_string(*hidden) +
                           " has no cell: its weight is too small");
    }
    return {std::move(sites), std::move(triangulation), weights};
}

/// Measures the cells of the sites of each orbit together.
CellAreas areas_of_orbits(const Sites& sites, const Eigen::VectorXd& weights,
                          const WeightOrbits& orbits) {
    // Triangulate.
    MovingDelaunay built(sites);
    const ReducedFrame frame = built.frame();
    const double unit = built.unit();
    auto [own_sites, triangulation] = built.release();
    const PeriodicDelaunay delaunay =
        made_regular(std::move(own_sites), std::move(triangulation), weights);
    // Measure the cells.
    const Eigen::VectorXd unit_weights = weights / (unit * unit);
    const WeightedTriangulation regular{.triangulation = delaunay.triangulation(),
                                        .coordinates = delaunay.sites().coordinates(),
                                        .frame = frame,
                                        .weights = unit_weights};
    Workers workers(1);
    std::vector<double> heights;
    Eigen::VectorXd mass;
    measure_masses(regular, workers, heights, mass);
    CellAreas cells{.area = orbits.sums(mass) * (unit * unit), .sensitivity = {}};
    CellGraph graph;
    assemble_cell_graph(regular, heights, workers, graph);
    graph = orbits.merged(std::move(graph));
    cells.sensitivity.setZero(graph.n_rows());
    for (int s = 0; s < graph.n_rows(); ++s) {
        for (int k = graph.row_begin[s]; k < graph.row_begin[s + 1]; ++k) {
            cells.sensitivity[s] += graph.conductance[k];
        }
    }
    return cells;
}

/// Measures the cells in the round space of their metric.
CellAreas areas_of(const StatedCells& cells, const Lattice& lattice, Points points) {
    if (cells.walls == Walls::kNone) return power_cell_areas(Sites(lattice, points), cells.weights);
    // Rounding may have moved a site on a wall beyond it.
    for (int axis = 0; axis < 2; ++axis) {
        if (!has_walls_across(cells.walls, axis)) continue;
        const double side = side_length(lattice, axis);
        for (Eigen::Index s = 0; s < points.cols(); ++s) {
            const double between = std::clamp(points(axis, s), 0.0, side);
            if (std::abs(points(axis, s) - between) <= cells.rounding) points(axis, s) = between;
        }
    }
    return power_cell_areas(lattice, cells.walls, points, cells.weights);
}

}  // namespace

double file_area_tolerance(int n_sites) { return kAreaTolerances * area_tolerance(n_sites); }

CellAreas power_cell_areas(const Sites& sites, const Eigen::VectorXd& weights) {
    return areas_of_orbits(sites, weights, {});
}

CellAreas power_cell_areas(const Lattice& domain, Walls walls, const Points& points,
                           const Eigen::VectorXd& weights) {
    const SymmetricSites sites = walled_sites(domain, walls, points);
    const WeightOrbits orbits(sites.orbit);
    CellAreas cells = areas_of_orbits(sites.sites, orbits.spread(weights), orbits);
    cells.area /= n_images(walls);
    cells.sensitivity /= n_images(walls);
    return cells;
}

AreaComparison compare_areas(const StatedCells& cells, const Eigen::VectorXd& wanted) {
    const Lattice lattice = cells.metric.to_round(cells.lattice);
    const CellAreas found = areas_of(cells, lattice, cells.metric.to_round(cells.points));
    const auto n = static_cast<int>(wanted.size());
    const double spacing = std::sqrt(lattice.area() / n);
    // The change by rounding of the power distances of the corners of a cell: a corner lies within
    // `reach` of its sites.
    const double reach = spacing + std::sqrt(cells.weights.maxCoeff() - cells.weights.minCoeff());
    const double of_position = cells.metric.largest_stretch() * cells.rounding;
    const double of_weight = cells.weight_rounding * cells.weights.cwiseAbs().maxCoeff();
    const double rounding = 2 * (2 * reach * of_position + of_weight);
    const double least = file_area_tolerance(n * n_images(cells.walls));
    AreaComparison worst{.site = -1, .area = 0, .error = 0, .tolerance = least};
    for (int s = 0; s < n; ++s) {
        const double error = std::abs(found.area[s] - wanted[s]) / wanted[s];
        const double tolerance = std::max(least, found.sensitivity[s] * rounding / wanted[s]);
        if (worst.site >= 0 && error * worst.tolerance <= worst.error * tolerance) continue;
        worst = {.site = s, .area = found.area[s], .error = error, .tolerance = tolerance};
    }
    return worst;
}

}  // namespace pcvt::plane
