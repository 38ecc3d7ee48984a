#include "mesher/plane/cvt/coarse_levels.hpp"

#include <vector>

#include "mesher/optimize/level_share.hpp"

namespace pcvt::plane {
namespace {

/// How often the number of sites is quadrupled. More levels lead to lower minima, but the last
/// optimisation then takes longer.
constexpr int kRefinements = 2;
/// Problems with at most this many sites are not coarsened further.
constexpr int kCoarsest = 16;
/// The RMS residual at which a coarser problem is left for the next one, and the RMS residual below
/// which its long waves are preconditioned.
constexpr double kRmsTolerance = 1e-4;
constexpr double kPreconditionBelow = 1e-3;

/// The numbers of orbits of all levels, the finest first.
std::vector<int> levels(int n_orbits) {
    std::vector<int> orbits{n_orbits};
    while (orbits.size() <= kRefinements && orbits.back() > kCoarsest) {
        orbits.push_back((orbits.back() + 3) / 4);
    }
    return orbits;
}

}  // namespace

int coarsest_level(int n_orbits) { return levels(n_orbits).back(); }

bool run_coarse_levels(const LevelSizes& sizes, const CoarseStartOptions& options,
                       const CoarseLevel& level) {
    std::vector<int> orbits = levels(sizes.n_orbits);
    double n_all = 0;
    for (std::size_t k = 1; k < orbits.size(); ++k) n_all += sizes.n_sites(orbits[k]);
    LevelShare done(sizes.n_sites(orbits.back()), n_all, kRmsTolerance);
    bool cancelled = false;
    CvtOptions of_level;
    // Where the density is not smooth, an RMS residual of 1e-4 may be out of reach.
    of_level.run.tolerance = options.density ? kRmsTolerance : 0;
    of_level.run.n_threads = options.n_threads;
    of_level.precondition_below = kPreconditionBelow;
    of_level.density = options.density;
    for (; orbits.size() > 1 && !cancelled; orbits.pop_back()) {
        const int n_finer = orbits[orbits.size() - 2];
        const double share = sizes.n_sites(orbits.back()) / sizes.n_sites(sizes.n_orbits);
        of_level.run.progress = [&](Progress progress) {
            progress.value *= share;
            progress.share = done.at(progress.rms_residual);
            cancelled = options.progress && !options.progress(progress);
            return !cancelled && progress.rms_residual > kRmsTolerance;
        };
        level(of_level, n_finer, options.seed + static_cast<std::uint64_t>(n_finer));
        done.next_level(sizes.n_sites(n_finer));
    }
    return !cancelled;
}

}  // namespace pcvt::plane
