#pragma once

#include "plugin/cli/exit_code.hpp"
#include "plugin/cli/study_options.hpp"

namespace pcvt::cli {

/// `pcvt study`: computes or merges the runs, shows progress, writes the files and prints the main
/// table.
/// @param request  from make_study_request, with the same options.
/// @throws the exceptions of describe_failure.
ExitCode run_study_command(const StudyRequest& request, const StudyOptions& options);

}  // namespace pcvt::cli
