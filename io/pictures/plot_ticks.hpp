#pragma once

#include <string>
#include <vector>

namespace pcvt {

/// Returns the ticks of an axis from `low` to `high`, rising. Ticks of a linear axis have a
/// distance of 1, 2 or 5 times a power of ten. A logarithmic axis takes the first of these sets
/// with at least three ticks: powers of ten; their multiples by 1, 2 and 5; by 1 to 9; the ticks of
/// a linear axis.
std::vector<double> axis_ticks(double low, double high, bool logarithmic);

/// The labels of the ticks of one axis, and the power of ten that multiplies them.
struct TickLabels {
    std::vector<std::string> texts;
    std::string factor;
};

/// Returns the labels of ticks that axis_ticks() returned.
TickLabels tick_labels(const std::vector<double>& ticks, bool logarithmic);

}  // namespace pcvt
