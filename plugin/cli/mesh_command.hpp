#pragma once

#include "plugin/cli/exit_code.hpp"
#include "plugin/cli/mesh_options.hpp"

namespace pcvt::cli {

/// `pcvt mesh`: reads the sites, runs the job, shows progress and prints the summary.
/// @param job  as make_job gave it.
/// @throws whatever describe_failure knows.
ExitCode run_mesh(Job job, const MeshOptions& options);

}  // namespace pcvt::cli
