#pragma once

#include <string>

#include "mesher/optimize/objective.hpp"
#include "plugin/cli/terminal/status_line.hpp"
#include "plugin/cli/terminal/time_left.hpp"

namespace pcvt::cli {

/// The status line of an optimisation: the iteration, the energy over the hexagonal bound, the
/// residual and the time left. For a global search it shows the number of starts, the lowest energy
/// and the share of the budget spent.
///
///   ProgressDisplay display(hexagonal_bound(area, n), tolerance, true);
///   run_job(job, [&](const Progress& progress) { display.show(progress); return true; });
class ProgressDisplay {
   public:
    /// @param energy_bound  divides the energies.
    /// @param tolerance     the residual at which the run ends.
    /// @param wanted        false: silent also on a terminal.
    ProgressDisplay(double energy_bound, double tolerance, bool wanted);

    void show(const Progress& progress);

   private:
    double energy_bound_;
    double tolerance_;
    StatusLine line_;
    TimeLeft time_left_;
};

/// The text of the line. `seconds_left` below 0 means unknown.
std::string progress_line(const Progress& progress, double energy_bound, double seconds_left);

}  // namespace pcvt::cli
