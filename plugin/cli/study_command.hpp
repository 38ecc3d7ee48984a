#pragma once

#include "plugin/cli/exit_code.hpp"
#include "plugin/cli/study_options.hpp"

namespace pcvt::cli {

/// `pcvt study`: does or merges the runs, shows progress, writes the files and prints the main
/// table.
/// @param request  as make_study_request gave it.
/// @throws whatever describe_failure knows.
ExitCode run_study_command(const StudyRequest& request, const StudyOptions& options);

}  // namespace pcvt::cli
