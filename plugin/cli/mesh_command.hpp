#pragma once

#include "plugin/cli/exit_code.hpp"
#include "plugin/cli/mesh_options.hpp"

namespace pcvt::cli {

/// `pcvt mesh`: reads the sites, runs the job, shows progress and prints the summary.
/// @param job  from make_job, with the same options.
/// @throws the exceptions of describe_failure.
ExitCode run_mesh(Job job, const MeshOptions& options);

}  // namespace pcvt::cli
