#include "mesher/coarse_start.hpp"

#include <cmath>
#include <random>

namespace pcvt {
namespace {

/// From the coarsest problem on the number of sites grows fourfold twice: more steps lead to lower
/// minima, but to those the last optimisation takes longer.
constexpr int kRefinements = 2;
/// Fewer sites are not refined any further.
constexpr int kCoarsest = 16;
/// How far a site is shaken, in units of h of the finer problem: without, sites stay where they
/// were set although their neighbourhood is a bad one.
constexpr double kShake = 0.25;
/// Where a coarser problem is left for the next, and where its long waves are treated apart.
constexpr double kRmsTolerance = 1e-4;
constexpr double kPreconditionBelow = 1e-3;

/// The optimised sites and the midpoints between them; the last ones are left out beyond n.
Points with_midpoints(const PeriodicDelaunay& delaunay, int n) {
    const Sites& sites = delaunay.sites();
    const TorusTriangulation& t = delaunay.triangulation();
    Points coordinates(2, n);
    int filled = 0;
    const auto put = [&](const Vec2& u) {
        if (filled < n) coordinates.col(filled++) = u;
    };
    for (SiteId s = 0; s < sites.n_sites(); ++s) put(sites.coordinates().col(s));
    for (int h = 0; h < t.n_halfedges(); ++h) {
        if (h > t.opposite(h)) continue;
        const Corner from = t.corner(h);
        const Corner to = t.corner(TorusTriangulation::next(h));
        const Vec2 way = difference(image(sites.coordinates(), from.site, from.offset),
                                    image(sites.coordinates(), to.site, to.offset));
        put(sites.coordinates().col(from.site) + way / 2);
    }
    return coordinates;
}

/// Coordinates in the reduced basis to points, each moved by a random part of the shake.
Points shaken(const Lattice& reduced, const Points& coordinates, std::uint64_t seed) {
    const double h = std::sqrt(reduced.area() / static_cast<double>(coordinates.cols()));
    std::mt19937_64 generator(seed);
    const auto uniform = [&generator] { return std::ldexp(double(generator() >> 11), -52) - 1; };
    Points points(2, coordinates.cols());
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        const double x = uniform();
        const double y = uniform();
        points.col(s) = reduced.to_plane(coordinates.col(s)) + kShake * h * Vec2(x, y);
    }
    return points;
}

}  // namespace

Points coarse_start(const Lattice& lattice, int n, const CoarseStartOptions& options) {
    const int n_wanted = n;
    std::vector<int> finer;
    for (; finer.size() < kRefinements && n > kCoarsest; n = (n + 3) / 4) finer.push_back(n);
    Points points = uniform_points(lattice, n, options.seed);
    for (; !finer.empty(); finer.pop_back()) {
        bool cancelled = false;
        CvtOptions level;
        level.tolerance = 0;
        level.n_threads = options.n_threads;
        level.precondition_below = kPreconditionBelow;
        const double share = double(points.cols()) / n_wanted;
        level.progress = [&](Progress progress) {
            progress.value *= share;
            cancelled = options.progress && !options.progress(progress);
            return !cancelled && progress.rms_residual > kRmsTolerance;
        };
        const CvtResult coarse = compute_cvt(lattice, std::move(points), level);
        if (cancelled) return {};
        const Points midpoints = with_midpoints(coarse.delaunay, finer.back());
        points = shaken(coarse.delaunay.sites().reduction().reduced, midpoints,
                        options.seed + static_cast<std::uint64_t>(finer.back()));
    }
    return points;
}

}  // namespace pcvt
