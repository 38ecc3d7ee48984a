#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "io/bytes/nearest_word.hpp"
#include "mesher/base/choices.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/lattice.hpp"
#include "mesher/space/geometry/lattice.hpp"
#include "mesher/torus/repetition.hpp"
#include "mesher/torus/voxels.hpp"

namespace pcvt::cli {

// Values of options, read strictly and independently of the locale:
//
//   job.n_sites = whole_number("--sites", options.sites, 1, kMostSites);
//   job.run.solver = chosen_row("--solver", options.solver, kSolvers).solver;
//
// Each function throws InvalidInput "OPTION VALUE: what is wrong; what to do".

/// The row of a table of choices (mesher/base/choices.hpp) that a word names.
template <class Table>
const auto& chosen_row(const std::string& option, const std::string& word, const Table& table) {
    if (const auto* row = find_word(table, word)) return *row;
    std::vector<std::string> words;
    for (const auto& row : table) {
        if (row.abi_value != kNotOffered) words.emplace_back(row.word);
    }
    const std::string meant = nearest_word(word, words);
    throw InvalidInput(option + " " + word + ": unknown; " +
                       (meant.empty() ? "take " + listed_words(table, ", ", " or ")
                                      : "did you mean " + meant + "?"));
}

constexpr int kMostThreads = 1024;

/// A whole number, at least `lowest`.
/// @throws LimitExceeded if it is above `highest`.
int whole_number(const std::string& option, const std::string& text, int lowest, int highest);

/// 0 ... 2^64 - 1.
std::uint64_t seed_number(const std::string& option, const std::string& text);

/// Finite and above 0.
double positive_number(const std::string& option, const std::string& text);

/// "X,Y", both finite.
plane::Vec2 point(const std::string& option, const std::string& text);

/// "X,Y,Z".
space::Vec3 space_point(const std::string& option, const std::string& text);

/// "W,H", both above 0.
plane::Lattice rectangle_lattice(const std::string& option, const std::string& text);

/// "AX,AY,BX,BY", two independent vectors.
plane::Lattice vector_lattice(const std::string& option, const std::string& text);

/// "W,H,D", all above 0: a box.
space::Lattice box_lattice(const std::string& option, const std::string& text);

/// "AX,AY,AZ,BX,BY,BZ,CX,CY,CZ", three independent vectors.
space::Lattice space_lattice(const std::string& option, const std::string& text);

/// "F" or "F,BETA", both finite.
std::array<double, 2> coriolis_parameter(const std::string& option, const std::string& text);

/// "NX,NY" or "NX,NY,NZ", whole numbers, the first two at least kLeastVoxels.
VoxelCounts voxel_counts(const std::string& option, const std::string& text);

/// "IxJ", or of three periods "IxJxK", whole numbers, at least 1.
Repetition repetition(const std::string& option, const std::string& text, int n_periods);

}  // namespace pcvt::cli
