#pragma once

#include <string>

#include "plugin/job/job.hpp"

namespace pcvt::cli {

/// What `pcvt mesh` prints on standard output when it is done.
std::string summary(const Job& job, const RunSummary& outcome);

}  // namespace pcvt::cli
