#pragma once

#include <vector>

#include "plugin/job/job_files.hpp"

namespace pcvt {

/// Formats without nodes in the middle of edges hold the corners alone, but one must have them.
/// @throws InvalidInput where a job of order 2 has files, and none holds it.
void check_order(const Job& job, const std::vector<JobFile>& files);

}  // namespace pcvt
