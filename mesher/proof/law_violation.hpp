#pragma once

#include <string>

#include "mesher/proof/validate.hpp"

namespace pcvt {

/// The name of law (1) of prove_tile() in messages.
inline constexpr const char* kFaceLaw = "(1), faces";
/// The name of the laws of prove_sites() in messages.
inline constexpr const char* kSiteLaw = "of the sites";

/// The message of a violation, "law <law>: <what>".
std::string violation_in_words(const std::string& law, const std::string& what);

/// Throws NotATile with violation_in_words().
///
/// Example usage:
///   throw_violation("(2), seam", "edge " + edge_in_words(3, 4) + " has no partner");
[[noreturn]] void throw_violation(const std::string& law, const std::string& what);

/// Format a value for a message: "1.23e-09", "(2, -1)", "3 -> 4".
std::string in_words(double amount);
std::string in_words(Offset offset);
std::string edge_in_words(int from, int to);

}  // namespace pcvt
