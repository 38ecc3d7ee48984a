#pragma once

#include <cstdint>
#include <string>

#include "mesher/lattice/lattice.hpp"

namespace pcvt::cli {

// Values of options, read strictly and independently of the locale. Each throws InvalidInput
// "OPTION VALUE: what; what to do".

/// A whole number from `lowest` on.
/// @throws LimitExceeded where it is a whole number above `highest`.
int whole_number(const std::string& option, const std::string& text, int lowest, int highest);

/// 0 ... 2^64 - 1.
std::uint64_t seed_number(const std::string& option, const std::string& text);

/// Finite and above 0.
double positive_number(const std::string& option, const std::string& text);

/// "X,Y", both finite.
Vec2 point(const std::string& option, const std::string& text);

/// "W,H", both above 0.
Lattice rectangle_lattice(const std::string& option, const std::string& text);

/// "AX,AY,BX,BY", two independent vectors.
Lattice vector_lattice(const std::string& option, const std::string& text);

struct Repetition {
    int columns;
    int rows;
};

/// "IxJ", whole numbers from 1 on.
Repetition repetition(const std::string& option, const std::string& text);

}  // namespace pcvt::cli
