#pragma once

#include <cstdlib>

namespace pcvt::testing {

/// The number of random cases that a variable of the environment states; without it the usual one.
///
/// Example usage:
///   const int n = case_count("PCVT_AREA_CASES", 300);
inline int case_count(const char* variable, int usual) {
    const char* const text = std::getenv(variable);
    return text != nullptr ? std::atoi(text) : usual;
}

}  // namespace pcvt::testing
