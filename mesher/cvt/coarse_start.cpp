#include "mesher/cvt/coarse_start.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "mesher/base/checkpoint.hpp"
#include "mesher/density/density_survey.hpp"

namespace pcvt {
namespace {

/// How often the number of sites is quadrupled. More levels lead to lower minima, but the last
/// optimisation then takes longer.
constexpr int kRefinements = 2;
/// Problems with at most this many sites are not coarsened further.
constexpr int kCoarsest = 16;
/// The largest shake of a coordinate, in units of h of the finer problem. Without it, sites stay at
/// their initial positions even where their neighbourhood is a poor one.
constexpr double kShake = 0.25;
/// The ratio of h to the distance between neighbours in a hexagonal arrangement.
const double kSpacingPerEdge = std::sqrt(std::sqrt(3.0) / 2);
/// The RMS residual at which a coarser problem is left for the next one, and the RMS residual below
/// which its long waves are preconditioned.
constexpr double kRmsTolerance = 1e-4;
constexpr double kPreconditionBelow = 1e-3;

/// The sites of the finer problem before they are shaken.
struct Refined {
    /// Reduced basis.
    Points coordinates;
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
    Refined finer{Points(2, n), Eigen::VectorXd::Zero(n)};
    finer.coordinates.leftCols(sites.n_sites()) = sites.coordinates();
    // Append the midpoint of each edge; the spacing of an old site is the mean over its edges.
    int next = sites.n_sites();
    for (int h = 0; h < t.n_halfedges(); ++h) {
        checkpoint_each(h);
        if (h > t.opposite(h)) continue;
        const Corner from = t.corner(h);
        const Corner to = t.corner(TorusTriangulation::next(h));
        const Vec2 way = difference(image(sites.coordinates(), from.site, from.offset),
                                    image(sites.coordinates(), to.site, to.offset));
        const double half = sites.reduction().reduced.to_plane(way).norm() / 2;
        for (const SiteId end : {from.site, to.site}) {
            finer.spacing[end] += kSpacingPerEdge * half / n_edges[end];
        }
        if (next == n) continue;
        finer.coordinates.col(next) = sites.coordinates().col(from.site) + way / 2;
        finer.spacing[next++] = kSpacingPerEdge * half;
    }
    return finer;
}

/// Measures how much of the work of all levels is done, from the sizes of the levels and from the
/// digits that the RMS residual of the current one has lost.
class LevelShare {
   public:
    LevelShare(double n_sites, const std::vector<int>& finer) : n_sites_(n_sites), n_all_(n_sites) {
        for (std::size_t k = 1; k < finer.size(); ++k) n_all_ += finer[k];
    }
    double at(double rms) {
        if (first_ == 0) first_ = rms;
        const bool measurable = first_ > kRmsTolerance && rms > 0;
        const double digits =
            measurable ? std::log(first_ / rms) / std::log(first_ / kRmsTolerance) : 0;
        return (n_before_ + n_sites_ * std::clamp(digits, 0.0, 1.0)) / n_all_;
    }
    void next_level(double n_sites) {
        n_before_ += n_sites_;
        n_sites_ = n_sites;
        first_ = 0;
    }

   private:
    double n_sites_;
    double n_all_;
    double n_before_ = 0;
    double first_ = 0;
};

/// Converts coordinates in the reduced basis to points and moves each by a random fraction of the
/// shake.
Points shaken(const Lattice& reduced, const Refined& sites, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    const auto uniform = [&generator] { return std::ldexp(double(generator() >> 11), -52) - 1; };
    Points points(2, sites.coordinates.cols());
    for (Eigen::Index s = 0; s < points.cols(); ++s) {
        checkpoint_each(s);
        const double x = uniform();
        const double y = uniform();
        points.col(s) =
            reduced.to_plane(sites.coordinates.col(s)) + kShake * sites.spacing[s] * Vec2(x, y);
    }
    return points;
}

}  // namespace

Points coarse_start(const Lattice& lattice, int n, const CoarseStartOptions& options) {
    // Compute the number of sites of each level.
    const int n_wanted = n;
    std::vector<int> finer;
    for (; finer.size() < kRefinements && n > kCoarsest; n = (n + 3) / 4) finer.push_back(n);
    // Draw the sites of the coarsest level.
    Points points = options.density ? graded_points(lattice, *options.density, n, options.seed)
                                    : uniform_points(lattice, n, options.seed);
    // Optimise each level, refine it and shake the sites of the next.
    LevelShare done(n, finer);
    for (; !finer.empty(); finer.pop_back()) {
        bool cancelled = false;
        CvtOptions level;
        // Where the density is not smooth, an RMS residual of 1e-4 may be out of reach.
        level.tolerance = options.density ? kRmsTolerance : 0;
        level.n_threads = options.n_threads;
        level.precondition_below = kPreconditionBelow;
        level.density = options.density;
        const double share = double(points.cols()) / n_wanted;
        level.progress = [&](Progress progress) {
            progress.value *= share;
            progress.share = done.at(progress.rms_residual);
            cancelled = options.progress && !options.progress(progress);
            return !cancelled && progress.rms_residual > kRmsTolerance;
        };
        const CvtResult coarse = compute_cvt(lattice, std::move(points), level);
        if (cancelled) return {};
        done.next_level(finer.back());
        Refined refined = with_midpoints(coarse.delaunay, finer.back());
        const Lattice& reduced = coarse.delaunay.sites().reduction().reduced;
        if (!options.density) refined.spacing.setConstant(std::sqrt(reduced.area() / finer.back()));
        points = shaken(reduced, refined, options.seed + static_cast<std::uint64_t>(finer.back()));
    }
    return points;
}

}  // namespace pcvt
