#pragma once

#include <algorithm>
#include <limits>

#include "mesher/optimize/objective.hpp"

namespace pcvt {

/// Ends a run whose centroids no longer come nearer, at one of its best iterations.
class CentroidPatience {
   public:
    bool is_over(const Progress& now) {
        best_ = std::min(best_, now.rms_residual);
        if (now.rms_residual < kNearer * mark_) {
            mark_ = now.rms_residual;
            since_ = now.iteration;
            return false;
        }
        const int waited = now.iteration - since_;
        const int patience = std::max(kFewestWaited, since_ / 2);
        return waited >= 2 * patience ||
               (waited >= patience && now.rms_residual <= kNearBest * best_);
    }

   private:
    static constexpr double kNearer = 0.9;
    static constexpr double kNearBest = 1.05;
    static constexpr int kFewestWaited = 100;

    double best_ = std::numeric_limits<double>::infinity();
    double mark_ = best_;
    int since_ = 0;
};

}  // namespace pcvt
