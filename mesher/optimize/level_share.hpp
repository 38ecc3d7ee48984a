#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcvt {

/// Measures how much of the work of a coarse start is done, from the sizes of its levels and from
/// the digits that the RMS residual of the current one has lost.
///
///     LevelShare share(n_coarsest, n_all_levels, 1e-4);
///     progress.share = share.at(progress.rms_residual);  // once an iteration
///     share.next_level(n_finer);
class LevelShare {
   public:
    /// @param rms_tolerance  the RMS residual at which a level ends.
    LevelShare(double n_sites, double n_all, double rms_tolerance)
        : n_sites_(n_sites), n_all_(n_all), rms_tolerance_(rms_tolerance) {}

    /// Returns the share of the work that is done, from 0 to 1; it never falls.
    double at(double rms) {
        if (first_ == 0) first_ = rms;
        least_ = std::min(least_, rms);
        const bool measurable = first_ > rms_tolerance_ && least_ > 0;
        const double digits =
            measurable ? std::log(first_ / least_) / std::log(first_ / rms_tolerance_) : 0;
        return (n_before_ + n_sites_ * std::clamp(digits, 0.0, 1.0)) / n_all_;
    }
    void next_level(double n_sites) {
        n_before_ += n_sites_;
        n_sites_ = n_sites;
        first_ = 0;
        least_ = std::numeric_limits<double>::infinity();
    }

   private:
    double n_sites_;
    double n_all_;
    double rms_tolerance_;
    double n_before_ = 0;
    double first_ = 0;
    double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace pcvt
