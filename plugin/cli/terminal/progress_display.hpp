#pragma once

#include <string>
#include <vector>

#include "plugin/cli/terminal/status_line.hpp"
#include "plugin/cli/terminal/time_left.hpp"
#include "plugin/job/job_progress.hpp"

namespace pcvt::cli {

/// The status line of a run: the phase and its share. An optimisation adds the time left, the
/// iteration, the residual and the energy over the hexagonal bound; a search adds the number of
/// starts and the lowest energy.
///
///   ProgressDisplay display(hexagonal_bound(area, n), tolerance, true);
///   run_job(job, [&](const JobProgress& progress) { display.show(progress); return true; });
class ProgressDisplay {
   public:
    /// @param energy_bound  divides the energies.
    /// @param tolerance     the residual at which the run ends.
    /// @param wanted        false: silent also on a terminal.
    ProgressDisplay(double energy_bound, double tolerance, bool wanted);

    void show(const JobProgress& progress);

   private:
    double energy_bound_;
    double tolerance_;
    StatusLine line_;
    TimeLeft time_left_;
    /// That of the last drawing.
    Phase phase_ = Phase::kStarting;
    int last_iteration_ = 0;
};

/// The parts of the line, most important first.
/// @param seconds       since the start of the run.
/// @param seconds_left  `nullopt`: unknown.
std::vector<std::string> progress_parts(const JobProgress& progress, double energy_bound,
                                        double seconds, std::optional<double> seconds_left);

}  // namespace pcvt::cli
