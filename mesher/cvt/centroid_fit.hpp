#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/cvt/centroid_objective.hpp"
#include "mesher/cvt/centroid_patience.hpp"
#include "mesher/optimize/convex_lbfgs.hpp"

namespace pcvt {

/// @param pairs  centroids within kNearestSites h of an earlier one.
/// @throws InvalidInput if there are any.
inline void require_apart(const std::vector<CoincidentSite>& pairs) {
    if (pairs.empty()) return;
    throw InvalidInput(
        "the centroids of grains " + std::to_string(pairs.front().earlier) + " and " +
        std::to_string(pairs.front().site) +
        " nearly coincide, which those of no power cells do; correct one of them, or "
        "merge the two grains");
}

/// The options of the optimiser for a CentroidObjective, whose point is that of `moving`.
/// @param run  must outlive the result.
template <class Moving>
OptimizerOptions centroid_options(const Moving& moving, const RunOptions& run) {
    OptimizerOptions options = optimizer_options(moving, run);
    if (run.progress) {
        const double unit = std::pow(moving.unit(), Moving::kDimension + 2);
        options.progress = [unit, &run](Progress now) {
            // Near the minimum this is the energy of the cells.
            now.value *= -unit;
            return run.progress(now);
        };
    }
    return options;
}

/// Minimises a CentroidObjective by L-BFGS.
/// @param sizes  those of the objective.
template <class Moving>
RunStatistics fit_centroids(const Moving& moving, const Eigen::VectorXd& sizes,
                            Objective& objective, const RunOptions& run) {
    CentroidPatience patience;
    OptimizerOptions options = centroid_options(moving, run);
    options.stop_when = [&](const Progress& now) { return patience.is_over(now); };
    Eigen::VectorXd scales(objective.n_variables());
    for (int s = 0; s < moving.n_sites(); ++s) {
        scales.segment<Moving::kNumbersPerSite>(Moving::kNumbersPerSite * s)
            .setConstant(1 / (2 * sizes[s]));
    }
    RunStatistics ended = minimize_convex(objective, scales, options).run;
    const bool is_fitted = ended.residual <= run.tolerance;
    if (ended.stop == Stop::kConverged && !is_fitted) ended.stop = Stop::kStalled;
    return ended;
}

}  // namespace pcvt
