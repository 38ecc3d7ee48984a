#pragma once

#include <string>

namespace pcvt::cli {

/// A figure for people to read: six digits.
std::string figure(double value);

/// Puts `text` on standard output.
/// @throws OutputError where it does not take it.
void print(const std::string& text);

}  // namespace pcvt::cli
