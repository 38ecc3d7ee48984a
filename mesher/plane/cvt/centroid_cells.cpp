#include "mesher/plane/cvt/centroid_cells.hpp"

#include <cmath>
#include <utility>

#include "mesher/cvt/centroid_fit.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "mesher/plane/power/power_diagram.hpp"

namespace pcvt::plane {
namespace {

void measure(const PowerDiagram& diagram, Workers& workers, Energy& cells) {
    measure_cells(diagram.regular(), diagram.heights(), workers, cells);
}

}  // namespace

CentroidCells fit_areas_and_centroids(const Lattice& lattice, const Points& centroids,
                                      const AreaCvtOptions& options) {
    require_areas(options, static_cast<int>(centroids.cols()));
    MovingDelaunay moving(Sites(lattice, centroids), Numbering::kAsGiven);
    require_distinct(moving);
    // Give the areas the order and the unit of the triangulation.
    const double unit = moving.unit();
    const int n = moving.n_sites();
    Eigen::VectorXd areas(n);
    for (SiteId s = 0; s < n; ++s) areas[s] = options.areas[moving.original_id(s)];
    areas *= moving.frame().ax * moving.frame().by / areas.sum();
    Workers workers(options.run.n_threads);
    CentroidObjective<EnergyPass, PowerDiagram> objective(moving, areas, workers,
                                                          options.newton_progress, measure);
    RunStatistics run = fit_centroids(moving, areas, objective, options.run);
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
