#pragma once

#include "plugin/cli/exit_code.hpp"
#include "plugin/cli/mesh_options.hpp"
#include "plugin/job/space_job.hpp"

namespace pcvt::cli {

/// Whether the period vectors are those of space: nine numbers of --lattice, or three of --period.
bool means_space(const MeshOptions& options);

/// The job that the options describe, without the sites of `options.input`, which it does not read.
///
///   if (means_space(options)) return run_space_mesh(make_space_job(app, options), options);
///
/// @param app  that of add_mesh_options, after parsing.
/// @throws InvalidInput, LimitExceeded naming the option, also for each option that applies to the
///         plane alone.
Job make_space_job(const CLI::App& app, const MeshOptions& options);

/// `pcvt mesh` in three dimensions: reads the sites, runs the job, shows progress and prints the
/// summary.
/// @throws the exceptions of describe_failure.
ExitCode run_space_mesh(Job job, const MeshOptions& options);

/// The text that is printed on standard output at the end: one "label value" a line.
std::string space_summary_text(const Job& job, const SpaceSummary& summary);

}  // namespace pcvt::cli
