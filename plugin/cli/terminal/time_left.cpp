#include "plugin/cli/terminal/time_left.hpp"

#include <algorithm>
#include <cmath>

namespace pcvt::cli {
namespace {

/// The fewest samples for a prediction.
constexpr std::size_t kFewest = 5;
/// The most samples; then the older half is dropped.
constexpr std::size_t kMost = 1024;

}  // namespace

void TimeLeft::add(double seconds, double residual) {
    if (!(residual > 0) || !std::isfinite(residual)) return;
    if (samples_.size() == kMost) samples_.erase(samples_.begin(), samples_.begin() + kMost / 2);
    samples_.push_back({seconds, std::log(residual)});
}

std::optional<double> TimeLeft::until(double target) const {
    if (samples_.size() < kFewest || !(target > 0)) return std::nullopt;
    const auto first = samples_.begin() + static_cast<std::ptrdiff_t>(samples_.size() / 2);
    const double count = static_cast<double>(samples_.end() - first);
    double mean_t = 0;
    double mean_y = 0;
    for (auto s = first; s != samples_.end(); ++s) {
        mean_t += s->seconds / count;
        mean_y += s->log_residual / count;
    }
    double tt = 0;
    double ty = 0;
    for (auto s = first; s != samples_.end(); ++s) {
        tt += (s->seconds - mean_t) * (s->seconds - mean_t);
        ty += (s->seconds - mean_t) * (s->log_residual - mean_y);
    }
    if (!(tt > 0) || !(ty < 0)) return std::nullopt;
    const double arrival = mean_t + (std::log(target) - mean_y) * tt / ty;
    return std::max(0.0, arrival - samples_.back().seconds);
}

}  // namespace pcvt::cli
