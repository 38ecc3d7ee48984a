#pragma once

#include <optional>
#include <vector>

namespace pcvt::cli {

/// Predicts when a residual that decreases about geometrically reaches its target.
///
/// Fits the slope of log(residual) over time to the later half of the samples, so that the fast
/// decrease at the beginning has no influence.
///
///   time_left.add(seconds, progress.residual);
///   const std::optional<double> seconds_left = time_left.until(1e-6);
class TimeLeft {
   public:
    /// @param seconds  since the start, increasing.
    void add(double seconds, double residual);

    /// Seconds until `target`; `nullopt` with too few samples, or if the residual does not
    /// decrease.
    std::optional<double> until(double target) const;

   private:
    struct Sample {
        double seconds;
        double log_residual;
    };
    std::vector<Sample> samples_;
};

}  // namespace pcvt::cli
