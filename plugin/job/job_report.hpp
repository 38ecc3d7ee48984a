#pragma once

#include <string>

#include "plugin/job/job.hpp"

namespace pcvt {

/// The JSON report of a run, its keys in the order that the report promises.
std::string encode_job_report(const Job& job, const RunSummary& outcome);

}  // namespace pcvt
