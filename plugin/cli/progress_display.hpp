#pragma once

#include <chrono>
#include <string>

#include "mesher/objective.hpp"
#include "plugin/cli/time_left.hpp"

namespace pcvt::cli {

/// One line on standard error, redrawn at most ten times a second and cleared at the end.
///
/// Shows the iteration, the energy over the hexagonal bound, the residual and the time left; of a
/// global search the starts, the lowest energy and the share of the budget that is spent. Silent
/// where standard error is no terminal.
class ProgressDisplay {
   public:
    /// @param energy_bound  what the energies are divided by.
    /// @param tolerance     the residual at which the run ends.
    /// @param wanted        false: stay silent on a terminal too.
    ProgressDisplay(double energy_bound, double tolerance, bool wanted);
    ~ProgressDisplay();
    ProgressDisplay(const ProgressDisplay&) = delete;
    ProgressDisplay& operator=(const ProgressDisplay&) = delete;

    void show(const Progress& progress);
    /// Takes the line off the terminal.
    void clear();

   private:
    using Clock = std::chrono::steady_clock;

    double energy_bound_;
    double tolerance_;
    bool shown_;
    Clock::time_point start_;
    Clock::time_point last_drawn_;
    std::size_t width_ = 0;
    TimeLeft time_left_;
};

/// The text of the line. `seconds_left` below 0 stands for unknown.
std::string progress_line(const Progress& progress, double energy_bound, double seconds_left);

}  // namespace pcvt::cli
