#pragma once

#include <Eigen/Core>
#include <string>

#include "plugin/job/job.hpp"

namespace pcvt::cli {

/// One line of such a text: the label and a value.
std::string summary_line(const char* label, const std::string& text);

/// The line that says which sites of a file were left out because they coincide with earlier ones.
/// @param n_kept  the number of the others, which asks for doubt where it is the smaller one.
std::string duplicates_line(const DroppedSites& dropped, Eigen::Index n_kept);

/// What the positions of given sites say about the domain: how many lie outside of it, or that all
/// are fractional coordinates by their looks; empty where nothing is noteworthy.
/// @param points   d x n, length units; no column: no site was given.
/// @param given    the same in lattice coordinates, from the corner of the domain.
/// @param reduced  the same for the reduced vectors, in whose box pcvt writes sites. The domain is
///                 the box that holds more of them.
std::string domain_note(const Eigen::ArrayXXd& points, const Eigen::ArrayXXd& given,
                        const Eigen::ArrayXXd& reduced);

/// The line that says whether the result is a minimum.
std::string minimum_line(const std::optional<Minimum>& minimum);

/// The line of a lattice that says whether it is a minimum.
std::string stability_line(const LatticeStability& stability);

/// The text that `pcvt mesh` prints on standard output at the end: one "label value" a line.
std::string summary_text(const Job& job, const RunSummary& summary);

}  // namespace pcvt::cli
