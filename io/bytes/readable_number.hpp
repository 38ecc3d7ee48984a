#pragma once

#include <string>

namespace pcvt {

/// Returns a number with at most six significant digits for readers, in every locale.
///
/// Example usage:
///     std::string line = "area " + figure(0.81);  // "area 0.81"
///     line += " in " + counted(1, "cell");        // "1 cell"; counted(2, "cell") is "2 cells"
std::string figure(double value);

/// Returns a number of things for readers: "1 site", "2 sites".
std::string counted(long n, const std::string& thing);

}  // namespace pcvt
