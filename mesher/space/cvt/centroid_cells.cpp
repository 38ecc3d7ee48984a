#include "mesher/space/cvt/centroid_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mesher/cvt/centroid_fit.hpp"
#include "mesher/space/cvt/distinct_sites.hpp"
#include "mesher/space/cvt/volume_newton.hpp"
#include "mesher/space/energy/energy_pass.hpp"
#include "mesher/space/power/power_cells.hpp"
#include "mesher/torus/coincident_sites.hpp"

namespace pcvt::space {
namespace {

void measure(const PowerDiagram& diagram, Workers& workers, Energy& cells) {
    measure_cells(diagram.regular(), workers, cells);
}

std::vector<SitePair<3>> pairs(const MovingTetrahedra& moving) {
    std::vector<SitePair<3>> found;
    for (int t = 0; t < moving.tetrahedra().n_tetrahedra(); ++t) {
        const Tetrahedron corners = moving.tetrahedra().tetrahedron(t);
        std::array<Vec3, 4> p;
        for (int c = 0; c < 4; ++c) {
            p[c] = moving.frame().to_position(image(moving.coordinates(), corners[c]).at);
            for (int e = 0; e < c; ++e) {
                if (corners[c].site == corners[e].site) continue;
                found.push_back({corners[e].site, corners[c].site, p[c] - p[e]});
            }
        }
    }
    return found;
}

/// @throws InvalidInput if two of the centroids nearly coincide.
Sites sites_apart(const Lattice& lattice, const Points& centroids) {
    Sites sites = distinct_sites(lattice, centroids);
    Eigen::Matrix3d periods;
    for (int k = 0; k < 3; ++k) periods.col(k) = sites.reduction().reduced.periods()[k];
    require_apart(coincident_sites(sites.coordinates(), periods, kNearestSites * sites.spacing()));
    return sites;
}

}  // namespace

CentroidCells fit_volumes_and_centroids(const Lattice& lattice, const Points& centroids,
                                        const VolumeCvtOptions& options) {
    require_volumes(options.volumes, lattice, centroids.cols());
    MovingTetrahedra moving(sites_apart(lattice, centroids));
    // Give the volumes the order and the unit of the tetrahedra.
    const int n = moving.n_sites();
    Eigen::VectorXd volumes(n);
    for (SiteId s = 0; s < n; ++s) volumes[s] = options.volumes[moving.original_id(s)];
    volumes *= moving.frame().volume() / volumes.sum();
    Workers workers(options.run.n_threads);
    CentroidObjective<EnergyPass, PowerDiagram> objective(moving, volumes, workers,
                                                          options.newton_progress, measure, pairs);
    RunStatistics run = fit_centroids(moving, volumes, objective, options.run);
    const CentroidFigures figures = objective.finish(volume_tolerance(n));
    run.residual = figures.largest;
    run.energy = objective.cells().value * std::pow(moving.unit(), 5);
    if (run.stop == Stop::kConverged && !objective.figures().converged) run.stop = Stop::kStalled;
    Eigen::VectorXd cell_volumes(n);
    for (SiteId s = 0; s < n; ++s) {
        cell_volumes[moving.original_id(s)] =
            objective.newton().sizes()[s] * std::pow(moving.unit(), 3);
    }
    const int n_rebuilds = moving.n_rebuilds();
    return {.grains = {.delaunay = weighted_delaunay(moving, objective.newton().diagram()),
                       .targets = options.volumes,
                       .cell_volumes = std::move(cell_volumes),
                       .run = run,
                       .volumes = objective.figures(),
                       .largest_error = objective.largest_error(),
                       .counts = objective.newton().diagram().counts(),
                       .n_rebuilds = n_rebuilds},
            .centroids = figures};
}

}  // namespace pcvt::space
