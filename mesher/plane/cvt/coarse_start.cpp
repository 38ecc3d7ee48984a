#include "mesher/plane/cvt/coarse_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/cvt/walled_cvt.hpp"
#include "mesher/plane/density/density_survey.hpp"

namespace pcvt::plane {
namespace {

/// The largest change of ln rho across a coarsest cell that resolves it.
constexpr double kMostChange = 3;

/// The sites of the finer problem before they are shaken.
struct Refined {
    /// Length units.
    Points points;
    /// For each site the local h, length units.
    Eigen::VectorXd spacing;
};

/// Returns the optimised sites and the midpoints of their Delaunay edges, truncated to n sites.
Refined with_midpoints(const PeriodicDelaunay& delaunay, int n) {
    const Sites& sites = delaunay.sites();
    const TorusTriangulation& t = delaunay.triangulation();
    // Copy the optimised sites.
    Eigen::VectorXd n_edges = Eigen::VectorXd::Zero(sites.n_sites());
    for (const SiteId site : t.corner_sites()) n_edges[site] += 1;
    const Lattice& reduced = sites.reduction().reduced;
    Refined finer{Points(2, n), Eigen::VectorXd::Zero(n)};
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        finer.points.col(s) = reduced.to_position(sites.coordinates().col(s));
    }
    // Append the midpoint of each edge; the spacing of an old site is the mean over its edges.
    int next = sites.n_sites();
    for (int h = 0; h < t.n_halfedges(); ++h) {
        checkpoint_each(h);
        if (h > t.opposite(h)) continue;
        const Corner from = t.corner(h);
        const Corner to = t.corner(TorusTriangulation::next(h));
        const Vec2 way = difference(image(sites.coordinates(), from.site, from.offset),
                                    image(sites.coordinates(), to.site, to.offset));
        const double half = reduced.to_position(way).norm() / 2;
        for (const SiteId end : {from.site, to.site}) {
            finer.spacing[end] += kSpacingPerEdge * half / n_edges[end];
        }
        if (next == n) continue;
        finer.points.col(next) =
            reduced.to_position(Vec2(sites.coordinates().col(from.site) + way / 2));
        finer.spacing[next++] = kSpacingPerEdge * half;
    }
    return finer;
}

/// The same between walls.
Refined with_midpoints(const WalledCvt& cvt, int n, std::uint64_t seed) {
    const Sites& sites = cvt.torus.delaunay.sites();
    const TorusTriangulation& t = cvt.torus.delaunay.triangulation();
    const WalledDomain& domain = cvt.domain;
    Eigen::VectorXd n_edges = Eigen::VectorXd::Zero(sites.n_sites());
    for (const SiteId site : t.corner_sites()) n_edges[site] += 1;
    // Ties between cocircular sites may hide an edge; its place remains random.
    Refined finer{uniform_points(domain.lattice, n, seed),
                  Eigen::VectorXd::Constant(n, std::sqrt(domain.lattice.area() / n))};
    const Points points = points_between_walls(cvt.torus.delaunay, domain);
    finer.points.leftCols(domain.n_sites) = points;
    finer.spacing.head(domain.n_sites).setZero();
    int next = domain.n_sites;
    for (int h = 0; h < t.n_halfedges(); ++h) {
        checkpoint_each(h);
        const Corner from = t.corner(h);
        const Corner to = t.corner(TorusTriangulation::next(h));
        if (from.site >= domain.n_sites) continue;
        const Vec2 u = difference(image(sites.coordinates(), from.site, from.offset),
                                  image(sites.coordinates(), to.site, to.offset));
        const Vec2 way = sites.reduction().reduced.to_position(u);
        const double half = way.norm() / 2;
        finer.spacing[from.site] += kSpacingPerEdge * half / n_edges[from.site];
        // An edge to the own image ends across one wall; others across walls are ties of four
        // images round a corner of cells on the wall.
        const bool is_inside = to.site < domain.n_sites;
        const bool is_image = !is_inside && (u.x() == 0 || u.y() == 0);
        const bool is_second = is_inside && h > t.opposite(h);
        if (next == n || is_second || !(is_inside || is_image)) continue;
        finer.points.col(next) = points.col(from.site) + way / (is_inside ? 2 : 4);
        finer.spacing[next++] = kSpacingPerEdge * half;
    }
    return finer;
}

/// Reflects points that lie beyond a wall.
void fold_between_walls(const Lattice& domain, Walls walls, Points& points) {
    for (int axis = 0; axis < 2; ++axis) {
        if (!has_walls_across(walls, axis)) continue;
        const double side = side_length(domain, axis);
        for (Eigen::Index s = 0; s < points.cols(); ++s) {
            double& at = points(axis, s);
            at = std::abs(at);
            if (at > side) at = 2 * side - at;
        }
    }
}

/// Moves each site by a random fraction of the shake.
Points shaken(Refined sites, std::uint64_t seed) {
    Shakes shakes(seed);
    Points points = std::move(sites.points);
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        checkpoint_each(s);
        const double x = shakes.next();
        const double y = shakes.next();
        points.col(s) += kShake * sites.spacing[s] * Vec2(x, y);
    }
    return points;
}

/// Optimises the sites of a level and refines them.
Refined optimised(const Lattice& lattice, Walls walls, Points points, CoarseLevels& levels,
                  const CoarseStartOptions& options) {
    const CvtOptions level = level_options(levels, options);
    const int n = levels.n_finer();
    Refined refined =
        walls == Walls::kNone
            ? with_midpoints(compute_cvt(lattice, std::move(points), level).delaunay, n)
            : with_midpoints(
                  compute_walled_cvt(lattice, walls, WallCells::kWhole, std::move(points), level),
                  n, levels.seed());
    if (!options.density) {
        refined.spacing.setConstant(std::sqrt(reduce(lattice).reduced.area() / n));
    }
    return refined;
}

}  // namespace

Points coarse_start(const Lattice& lattice, int n, std::uint64_t seed,
                    const CoarseStartOptions& options, Walls walls) {
    CoarseLevels levels(kLevelGrowth, {.n_orbits = n}, seed, options.run);
    const int n_coarsest = levels.n_coarsest();
    Points points = options.density ? graded_points(lattice, *options.density, n_coarsest, seed)
                                    : uniform_points(lattice, n_coarsest, seed);
    // Optimise each level, refine it and shake the sites of the next.
    while (levels.next()) {
        Refined refined = optimised(lattice, walls, std::move(points), levels, options);
        if (levels.cancelled()) return {};
        points = shaken(std::move(refined), levels.seed());
        fold_between_walls(lattice, walls, points);
    }
    return points;
}

bool is_resolved_by_coarse_cells(const Lattice& lattice, const Density& density, int n) {
    const CoarseLevels levels(kLevelGrowth, {.n_orbits = n}, 0, {});
    const double width = std::sqrt(lattice.area() / levels.n_coarsest());
    return DensitySurvey(lattice, density, kSurveyResolution).steepest() * width < kMostChange;
}

}  // namespace pcvt::plane
