#include "plugin/cli/terminal/progress_display.hpp"

#include <cstdio>

namespace pcvt::cli {
namespace {

/// Below this many seconds the time is shown in tenths.
constexpr double kInTenths = 100;

/// A number in the middle of a part: formatted("iteration %.0f", 12).
std::string formatted(const char* form, double number) {
    char text[64];
    std::snprintf(text, sizeof text, form, number);
    return text;
}

void add_iteration(const Progress& run, double energy_bound, std::vector<std::string>& parts) {
    // Before the first evaluation.
    if (run.evaluations == 0 && run.residual == 0) return;
    if (run.budget > 0) {
        parts.push_back(formatted("start %.0f", run.iteration));
        parts.push_back(formatted("lowest energy/bound %.6f", run.value / energy_bound));
        return;
    }
    parts.push_back(formatted("iteration %.0f", run.iteration));
    parts.push_back(formatted("residual %.0e", run.residual));
    parts.push_back(formatted("energy/bound %.4f", run.value / energy_bound));
}

}  // namespace

std::vector<std::string> progress_parts(const JobProgress& progress, double energy_bound,
                                        double seconds, std::optional<double> seconds_left) {
    std::string phase = progress.text;
    if (progress.fraction >= 0) phase += formatted(" %.0f %%", 100 * progress.fraction);
    std::vector<std::string> parts{phase};
    if (progress.phase > Phase::kOptimising) {
        // Tenths show that the run goes on where a step does not know its share.
        parts.push_back("after " + (seconds < kInTenths ? formatted("%.1f s", seconds)
                                                        : duration_in_words(seconds)));
        return parts;
    }
    if (seconds_left) parts.push_back(duration_in_words(*seconds_left) + " left");
    add_iteration(progress.run, energy_bound, parts);
    return parts;
}

ProgressDisplay::ProgressDisplay(double energy_bound, double tolerance, bool wanted)
    : energy_bound_(energy_bound), tolerance_(tolerance), line_(wanted) {}

void ProgressDisplay::show(const JobProgress& progress) {
    if (!line_.due(progress.phase != phase_)) return;
    phase_ = progress.phase;
    std::optional<double> seconds_left;
    if (progress.phase == Phase::kOptimising) {
        // A further seed begins from its own iteration 0.
        if (progress.run.iteration < last_iteration_) time_left_ = {};
        last_iteration_ = progress.run.iteration;
        time_left_.add(line_.seconds(), progress.run.residual);
        seconds_left = time_left_.until(tolerance_);
    }
    line_.draw(progress_parts(progress, energy_bound_, line_.seconds(), seconds_left));
}

}  // namespace pcvt::cli
