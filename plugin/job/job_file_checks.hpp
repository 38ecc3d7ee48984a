#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plugin/job/job_files.hpp"

namespace pcvt {

/// Requires a file that holds the mid-side nodes of a job of order 2. The files of other formats
/// hold its corners alone.
/// @throws InvalidInput if the job has files, and none of them holds mid-side nodes.
void check_order(const Job& job, const std::vector<JobFile>& files);

/// Requires for each choice in job.file_options a file whose format takes it.
/// @throws InvalidInput if the job has files, and none of them takes the choice.
void check_file_options(const Job& job, const std::vector<JobFile>& files);

/// The colour of "none" or "#rrggbb".
/// @throws InvalidInput for other words.
std::optional<Colour> background_colour(const std::string& word);

}  // namespace pcvt
