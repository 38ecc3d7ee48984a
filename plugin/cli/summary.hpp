#pragma once

#include <string>

#include "plugin/job/job.hpp"

namespace pcvt::cli {

/// One line of such a text: the label and a value.
std::string summary_line(const char* label, const std::string& text);

/// The text that `pcvt mesh` prints on standard output at the end: one "label value" a line.
std::string summary_text(const Job& job, const RunSummary& summary);

}  // namespace pcvt::cli
