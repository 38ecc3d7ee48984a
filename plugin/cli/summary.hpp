#pragma once

#include <string>

#include "plugin/job/job.hpp"

namespace pcvt::cli {

/// The text that `pcvt mesh` prints on standard output at the end: one "label value" a line.
std::string summary_text(const Job& job, const RunSummary& summary);

}  // namespace pcvt::cli
