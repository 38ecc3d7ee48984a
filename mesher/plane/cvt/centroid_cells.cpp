#include "mesher/plane/cvt/centroid_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mesher/plane/cvt/centroid_path.hpp"
#include "mesher/torus/coincident_sites.hpp"

namespace pcvt::plane {
namespace {

/// A walk along short edges between sites within the reach of each other stays within this multiple
/// of it.
constexpr double kFarthestWalk = 1.5;

void measure(const PowerDiagram& diagram, Workers& workers, Energy& cells) {
    measure_cells(diagram.regular(), diagram.heights(), workers, cells);
}

/// The edges between two sites, once each.
std::vector<SitePair<2>> edges(const MovingDelaunay& moving) {
    const TorusTriangulation& t = moving.triangulation();
    std::vector<SitePair<2>> found;
    for (int h = 0; h < t.n_halfedges(); ++h) {
        const Corner from = t.corner(h);
        const Corner to = t.corner(TorusTriangulation::next(h));
        if (h > t.opposite(h) || from.site == to.site) continue;
        const Vec2 apart = difference(image(moving.coordinates(), from.site, from.offset),
                                      image(moving.coordinates(), to.site, to.offset));
        found.push_back({from.site, to.site, moving.frame().to_position(apart)});
    }
    return found;
}

/// The edges, and the other pairs of sites within the reach of the repulsion. Edges shorter than
/// the distance of a pair lead from one of its sites to the other.
std::vector<SitePair<2>> pairs(const MovingDelaunay& moving) {
    std::vector<SitePair<2>> found = edges(moving);
    const double reach = CentroidPathObjective::kReach * moving.spacing();
    std::vector<std::vector<SitePair<2>>> near(static_cast<std::size_t>(moving.n_sites()));
    for (const SitePair<2>& edge : found) {
        if (!(edge.apart.norm() < reach)) continue;
        near[edge.from].push_back(edge);
        near[edge.to].push_back({edge.to, edge.from, -edge.apart});
    }
    for (SiteId s = 0; s < moving.n_sites(); ++s) {
        std::vector<SitePair<2>> walk = near[s];
        const auto is_known = [&](SiteId site) {
            return site == s || std::any_of(walk.begin(), walk.end(),
                                            [&](const auto& pair) { return pair.to == site; });
        };
        for (std::size_t k = 0; k < walk.size(); ++k) {
            for (const SitePair<2>& edge : near[walk[k].to]) {
                const Vec2 apart = walk[k].apart + edge.apart;
                if (!(apart.norm() < kFarthestWalk * reach) || is_known(edge.to)) continue;
                walk.push_back({s, edge.to, apart});
                if (s < edge.to && apart.norm() < reach) found.push_back(walk.back());
            }
        }
    }
    return found;
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
    CentroidPathObjective objective(moving, areas, workers, options.newton_progress, measure,
                                    pairs);
    RunStatistics run = follow_centroid_path(objective, options.run);
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
