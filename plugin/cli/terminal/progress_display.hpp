#pragma once

#include <string>

#include "mesher/optimize/objective.hpp"
#include "plugin/cli/terminal/status_line.hpp"
#include "plugin/cli/terminal/time_left.hpp"

namespace pcvt::cli {

/// The status line of an optimisation: the iteration, the energy over the hexagonal bound, the
/// residual and the time left; of a global search the starts, the lowest energy and the share of
/// the budget that is spent.
class ProgressDisplay {
   public:
    /// @param energy_bound  what the energies are divided by.
    /// @param tolerance     the residual at which the run ends.
    /// @param wanted        false: stay silent on a terminal too.
    ProgressDisplay(double energy_bound, double tolerance, bool wanted);

    void show(const Progress& progress);

   private:
    double energy_bound_;
    double tolerance_;
    StatusLine line_;
    TimeLeft time_left_;
};

/// The text of the line. `seconds_left` below 0 stands for unknown.
std::string progress_line(const Progress& progress, double energy_bound, double seconds_left);

}  // namespace pcvt::cli
