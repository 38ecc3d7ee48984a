#include "mesher/cvt/coarse_levels.hpp"

#include <algorithm>
#include <utility>

#include "mesher/portable/portable_functions.hpp"

namespace pcvt {
namespace {

std::vector<int> levels(const LevelGrowth& growth, int n_orbits) {
    std::vector<int> orbits{n_orbits};
    while (static_cast<int>(orbits.size()) < growth.most_levels &&
           orbits.back() > growth.coarsest) {
        orbits.push_back(static_cast<int>(std::ceil(orbits.back() / growth.factor)));
    }
    std::reverse(orbits.begin(), orbits.end());
    return orbits;
}

/// The sites of all levels but the finest, summed up from fine to coarse.
double n_all_sites(const LevelSizes& sizes, const std::vector<int>& orbits) {
    double n_all = 0;
    for (auto level = orbits.rbegin() + 1; level != orbits.rend(); ++level) {
        n_all += sizes.n_sites(*level);
    }
    return n_all;
}

}  // namespace

CoarseLevels::CoarseLevels(const LevelGrowth& growth, const LevelSizes& sizes, std::uint64_t seed,
                           RunOptions run)
    : growth_(growth),
      sizes_(sizes),
      seed_(seed),
      run_(std::move(run)),
      orbits_(levels(growth, sizes.n_orbits)),
      done_(sizes.n_sites(orbits_.front()), n_all_sites(sizes, orbits_), kCoarseTolerance) {}

bool CoarseLevels::next() {
    if (++level_ > 0) done_.next_level(sizes_.n_sites(orbits_[level_]));
    return level_ + 1 < static_cast<int>(orbits_.size());
}

double CoarseLevels::energy_scale() const {
    const double share = sizes_.n_sites(orbits_[level_]) / sizes_.n_sites(orbits_.back());
    if (growth_.dimension == 2) return share;
    const double length = portable_cbrt(share);
    return length * length;
}

RunOptions CoarseLevels::run() {
    return {.tolerance = 0,
            .n_threads = run_.n_threads,
            .progress = [this, scale = energy_scale()](Progress progress) {
                progress.value *= scale;
                progress.share = done_.at(progress.rms_residual);
                cancelled_ = run_.progress && !run_.progress(progress);
                return !cancelled_ && progress.rms_residual > kCoarseTolerance;
            }};
}

}  // namespace pcvt
