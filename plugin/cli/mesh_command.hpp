#pragma once

#include <optional>
#include <vector>

#include "plugin/cli/exit_code.hpp"
#include "plugin/cli/mesh_options.hpp"

namespace pcvt::cli {

/// `pcvt mesh`: reads the sites, runs the job, shows progress and prints the summary.
/// @param job  from make_job, with the same options.
/// @throws the exceptions of describe_failure.
ExitCode run_mesh(Job job, const MeshOptions& options);

/// Says on standard error how much memory a run takes, and how much there is.
/// @param estimate  bytes.
void announce_memory(double estimate, const std::optional<double>& available);

/// Report the end of a cancelled run, or of one that did not converge, on standard error.
/// @returns the exit code of the command.
ExitCode report_cancelled();
ExitCode report_not_converged(const RunStatistics& run, double tolerance);

/// Reports the outputs that a run has left out on standard error, in one line.
/// @param n_written  the number of the other files.
/// @pre `refused` is not empty.
ExitCode report_refused(const std::vector<RefusedFile>& refused, std::size_t n_written);

}  // namespace pcvt::cli
