#pragma once

#include <string>

namespace pcvt::cli {

/// A number with six digits for readers: print("energy " + figure(energy) + "\n").
std::string figure(double value);

/// Writes `text` to standard output.
/// @throws OutputError if the write fails.
void print(const std::string& text);

}  // namespace pcvt::cli
