#pragma once

#include <string>

#include "plugin/job/job.hpp"

namespace pcvt {

/// The JSON report of a run, its keys in the order of io/run_files/report.hpp.
std::string encode_job_report(const Job& job, const RunSummary& summary);

}  // namespace pcvt
