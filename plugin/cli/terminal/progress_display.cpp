#include "plugin/cli/terminal/progress_display.hpp"

#include <cstdio>

namespace pcvt::cli {

std::string progress_line(const Progress& progress, double energy_bound, double seconds_left) {
    char text[96];
    if (progress.budget > 0) {
        std::snprintf(text, sizeof text,
                      "search: start %d  lowest energy/bound %.6f  %.0f %% of the budget",
                      progress.iteration, progress.value / energy_bound,
                      100.0 * progress.evaluations / progress.budget);
        return text;
    }
    std::snprintf(text, sizeof text, "iteration %d  energy/bound %.6f  residual %.1e",
                  progress.iteration, progress.value / energy_bound, progress.residual);
    if (seconds_left < 0) return text;
    return text + std::string("  about ") + duration_in_words(seconds_left) + " left";
}

ProgressDisplay::ProgressDisplay(double energy_bound, double tolerance, bool wanted)
    : energy_bound_(energy_bound), tolerance_(tolerance), line_(wanted) {}

void ProgressDisplay::show(const Progress& progress) {
    if (!line_.due()) return;
    if (progress.budget == 0) time_left_.add(line_.seconds(), progress.residual);
    line_.draw(progress_line(progress, energy_bound_, time_left_.until(tolerance_).value_or(-1)));
}

}  // namespace pcvt::cli
