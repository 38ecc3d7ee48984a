#pragma once

#include <string>

#include "plugin/job/space_job.hpp"

namespace pcvt {

/// The JSON report of a run in space, as encode_job_report().
/// @param seconds_writing  from the optimised sites to the last file.
std::string encode_space_report(const Job& job, const SpaceSummary& summary,
                                double seconds_optimising, double seconds_writing);

}  // namespace pcvt
