#pragma once

#include <string>

#include "mesher/proof/validate.hpp"

namespace pcvt {

/// Throws NotATile with the message "law <law>: <what>".
[[noreturn]] void throw_violation(const std::string& law, const std::string& what);

/// Words for the messages: "1.23e-09", "(2, -1)", "3 -> 4".
std::string in_words(double amount);
std::string in_words(Offset offset);
std::string edge_in_words(int from, int to);

}  // namespace pcvt
