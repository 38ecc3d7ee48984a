#pragma once

#include <optional>
#include <vector>

namespace pcvt::cli {

/// Foretells when a residual that falls about geometrically will reach its target.
///
/// The slope of log(residual) over time is fitted to the later half of what was seen, so that the
/// fast fall of the beginning is forgotten.
class TimeLeft {
   public:
    /// @param seconds  since the start, rising.
    void add(double seconds, double residual);

    /// Seconds until `target`; nothing while too little was seen or the residual does not fall.
    std::optional<double> until(double target) const;

   private:
    struct Sample {
        double seconds;
        double log_residual;
    };
    std::vector<Sample> samples_;
};

}  // namespace pcvt::cli
