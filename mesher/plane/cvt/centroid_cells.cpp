#include "mesher/plane/cvt/centroid_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesher/cvt/centroid_fit.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "mesher/plane/power/power_diagram.hpp"
#include "mesher/torus/coincident_sites.hpp"

namespace pcvt::plane {
namespace {

void measure(const PowerDiagram& diagram, Workers& workers, Energy& cells) {
    measure_cells(diagram.regular(), diagram.heights(), workers, cells);
}

void derivatives(const PowerDiagram& diagram, double unit, BlockMatrix& matrix) {
    assemble_moment_derivatives(diagram.regular(), diagram.heights(), unit, matrix);
}

/// Each site is joined to its nearest neighbour by a Delaunay edge.
double shortest_edge(const MovingDelaunay& moving) {
    const TorusTriangulation& t = moving.triangulation();
    double least = std::numeric_limits<double>::infinity();
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const Corner from = t.corner(h);
        const Corner to = t.corner(TorusTriangulation::next(h));
        const Vec2 edge = moving.frame().to_position(
            difference(image(moving.coordinates(), from.site, from.offset),
                       image(moving.coordinates(), to.site, to.offset)));
        least = std::min(least, edge.squaredNorm());
    }
    return std::sqrt(least);
}

/// @throws InvalidInput if two of the centroids nearly coincide.
void require_apart(const Sites& sites) {
    Eigen::Matrix2d periods;
    periods.col(0) = sites.reduction().reduced.a();
    periods.col(1) = sites.reduction().reduced.b();
    pcvt::require_apart(
        coincident_sites(sites.coordinates(), periods, kNearestSites * sites.spacing()));
}

}  // namespace

CentroidCells fit_areas_and_centroids(const Lattice& lattice, const Points& centroids,
                                      const AreaCvtOptions& options) {
    require_areas(options, static_cast<int>(centroids.cols()));
    const Sites sites(lattice, centroids);
    MovingDelaunay moving(sites, Numbering::kAsGiven);
    require_distinct(moving);
    require_apart(sites);
    // Give the areas the order and the unit of the triangulation.
    const double unit = moving.unit();
    const int n = moving.n_sites();
    Eigen::VectorXd areas(n);
    for (SiteId s = 0; s < n; ++s) areas[s] = options.areas[moving.original_id(s)];
    areas *= moving.frame().ax * moving.frame().by / areas.sum();
    Workers workers(options.run.n_threads);
    CentroidObjective<EnergyPass, PowerDiagram> objective(
        moving, areas, workers, options.newton_progress, measure, shortest_edge, derivatives);
    RunStatistics run =
        fit_centroids(moving, areas, objective, options.run,
                      [&](const Evaluation& here, Eigen::VectorXf& direction) {
                          return objective.newton_step(here, longest_move(moving), direction);
                      });
    const CentroidFigures figures = objective.finish(area_tolerance(n));
    run.residual = figures.largest;
    run.energy = objective.cells().value * std::pow(unit, 4);
    if (run.stop == Stop::kConverged && !objective.figures().converged) run.stop = Stop::kStalled;
    Eigen::VectorXd weights(n);
    for (SiteId s = 0; s < n; ++s) {
        weights[moving.original_id(s)] = objective.newton().weights()[s] * unit * unit;
    }
    const DelaunayCounts counts = moving.counts();
    return {.grains = {.delaunay = weighted_delaunay(moving.release(), std::move(weights)),
                       .run = run,
                       .areas = objective.figures(),
                       .counts = counts},
            .centroids = figures};
}

}  // namespace pcvt::plane
