#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "mesher/base/choices.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::abi {

// Checks of single fields, in the plane and in space. They throw InvalidInput naming the field.

/// Requires that n numbers are finite.
void require_finite(const char* name, const double* values, int n);

/// Requires that points, n of `dimension` numbers each, are finite.
/// @param name  of one of them: "site".
void require_finite_points(const char* name, const double* numbers, int n, int dimension);

/// Requires a positive, finite number.
void require_positive(const char* name, double value);

/// A positive, finite number, or `nullopt` for 0, which leaves the field out.
std::optional<double> positive_or_none(const char* name, double value);

/// The lattice of the field `lattice`, four numbers ax, ay, bx, by.
plane::Lattice plane_lattice(const double* numbers);

/// Requires that sites which are given begin nowhere else.
void require_one_start(const double* sites, std::int32_t start);

/// A text that may be left out; nullptr: empty.
inline std::string given_text(const char* text) { return text == nullptr ? "" : text; }

/// The number of threads that the field n_threads means.
int thread_count(std::int32_t wanted);

/// The row of a table of choices that has this number in pcvt.h.
template <class Table>
const auto& chosen_row(const char* name, std::int32_t value, const Table& table) {
    if (const auto* row = find_abi_value(table, value)) return *row;
    throw InvalidInput(std::string(name) + " " + std::to_string(value) +
                       " is unknown; take one of pcvt.h");
}

/// The row of a table of choices that has this number, of those that the dimension has.
/// @param words  of the choices in space, for the message.
template <class Table>
const auto& row_for(bool in_space, const char* name, std::int32_t value, const Table& table,
                    const char* words) {
    if (!in_space) return chosen_row(name, value, table);
    const auto* const row = find_abi_value(table, value);
    if (row != nullptr && row->in_space) return *row;
    throw InvalidInput(std::string(name) + " " + std::to_string(value) +
                       " is not for three dimensions; take " + words);
}

}  // namespace pcvt::abi
