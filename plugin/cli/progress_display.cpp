#include "plugin/cli/progress_display.hpp"

#include <unistd.h>

#include <cstdio>

namespace pcvt::cli {
namespace {

constexpr std::chrono::milliseconds kBetweenDrawings{100};

std::string duration(double seconds) {
    char text[32];
    if (seconds < 100) {
        std::snprintf(text, sizeof text, "%.0f s", seconds);
    } else if (seconds < 6000) {
        std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
    } else {
        std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
    }
    return text;
}

}  // namespace

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
    return text + std::string("  about ") + duration(seconds_left) + " left";
}

ProgressDisplay::ProgressDisplay(double energy_bound, double tolerance, bool wanted)
    : energy_bound_(energy_bound),
      tolerance_(tolerance),
      shown_(wanted && isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_drawn_(start_) {}

ProgressDisplay::~ProgressDisplay() { clear(); }

void ProgressDisplay::show(const Progress& progress) {
    if (!shown_) return;
    const Clock::time_point now = Clock::now();
    if (now - last_drawn_ < kBetweenDrawings) return;
    last_drawn_ = now;
    if (progress.budget == 0)
        time_left_.add(std::chrono::duration<double>(now - start_).count(), progress.residual);
    std::string line =
        progress_line(progress, energy_bound_, time_left_.until(tolerance_).value_or(-1));
    const std::size_t length = line.size();
    // Spaces over what is left of the line before: dumb terminals know no "clear to the end".
    if (length < width_) line.append(width_ - length, ' ');
    width_ = length;
    std::fprintf(stderr, "\r%s", line.c_str());
    std::fflush(stderr);
}

void ProgressDisplay::clear() {
    if (width_ == 0) return;
    std::fprintf(stderr, "\r%s\r", std::string(width_, ' ').c_str());
    std::fflush(stderr);
    width_ = 0;
}

}  // namespace pcvt::cli
