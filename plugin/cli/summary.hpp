#pragma once

#include <string>

#include "io/bytes/readable_number.hpp"
#include "plugin/job/job.hpp"
#include "plugin/job/run_summary.hpp"

namespace pcvt::cli {

/// One line of such a text: the label and a value.
std::string summary_line(const char* label, const std::string& text);

/// "(1, 0.5)"
template <class Vector>
std::string vector_text(const Vector& v) {
    std::string text;
    // Adding 0 turns -0 into 0.
    for (const double x : v) text += (text.empty() ? "(" : ", ") + figure(x + 0.0);
    return text + ")";
}

/// "(1, 0) (0, 1)"
template <class Vectors>
std::string vectors_text(const Vectors& vectors) {
    std::string text;
    for (const auto& v : vectors) text += (text.empty() ? "" : " ") + vector_text(v);
    return text;
}

/// The text that `pcvt mesh` prints on standard output at the end: one "label value" a line.
std::string summary_text(const Job& job, const RunSummary& summary);

}  // namespace pcvt::cli
