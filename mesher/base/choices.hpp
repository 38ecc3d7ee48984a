#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace pcvt {

// Lookups in a table of choices: an array of rows that have the members `word`, the word of options
// and reports, and `abi_value`, the number of the C interface.
//
//   if (const SolverRow* row = find_word(kSolvers, "newton")) options.solver = row->solver;
//   throw InvalidInput("take " + listed_words(kSolvers, ", ", " or "));

/// The `abi_value` of a row that neither the command nor the C interface offers.
inline constexpr int kNotOffered = -1;

/// The first row that `matches`, or nullptr.
template <class Table, class Matches>
constexpr auto find_row(const Table& table, const Matches& matches) {
    const auto found = std::find_if(std::begin(table), std::end(table), matches);
    return found == std::end(table) ? nullptr : &*found;
}

/// The row that is offered under this word, or nullptr.
template <class Table>
constexpr auto find_word(const Table& table, std::string_view word) {
    return find_row(table, [word](const auto& row) {
        return row.abi_value != kNotOffered && row.word == word;
    });
}

/// The row that the C interface offers under this number, or nullptr.
template <class Table>
constexpr auto find_abi_value(const Table& table, int value) {
    return find_row(table, [value](const auto& row) {
        return row.abi_value != kNotOffered && row.abi_value == value;
    });
}

/// The words that are offered, in the order of the table: "lbfgs, lloyd or newton".
template <class Table>
std::string listed_words(const Table& table, std::string_view between, std::string_view last) {
    std::string text;
    std::string_view pending;
    for (const auto& row : table) {
        if (row.abi_value == kNotOffered) continue;
        if (!pending.empty()) text.append(text.empty() ? "" : between).append(pending);
        pending = row.word;
    }
    return text.append(text.empty() ? "" : last).append(pending);
}

}  // namespace pcvt
