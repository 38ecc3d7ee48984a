#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/torus/walls.hpp"

namespace pcvt {

// The names of the sets, groups, patches and zones in files, or their beginnings before numbers.
// Writers form all names by them, in lower case, .inp files in capitals; solvers do not see case.
inline constexpr std::string_view kAllNodesSet = "nall";
inline constexpr std::string_view kAllElementsSet = "eall";
inline constexpr std::string_view kFixedSet = "fixed";
inline constexpr std::string_view kControlSet = "control_";
inline constexpr std::string_view kGrainBoundarySet = "grain_boundary";
inline constexpr std::string_view kTriplePointsSet = "triple_points";
inline constexpr std::string_view kTripleLinesSet = "triple_lines";
inline constexpr std::string_view kQuadruplePointsSet = "quadruple_points";
inline constexpr std::string_view kCellSet = "cell_";
inline constexpr std::string_view kPhaseSet = "phase_";
inline constexpr std::string_view kOrbitSet = "orbit_";
inline constexpr std::string_view kOrientationSet = "ori_";
inline constexpr std::string_view kSeamSet = "seam_";
inline constexpr std::string_view kSideSet = "side_";
inline constexpr std::string_view kEdgeSet = "edge_";
inline constexpr std::string_view kCornerSet = "corner_";
inline constexpr std::string_view kBackPatch = "back";
inline constexpr std::string_view kFrontPatch = "front";
inline constexpr std::string_view kDomainSet = "domain";
/// Follows the name of a wall, a hole or a boundary in the name of its surface of element sides.
inline constexpr std::string_view kSidesSuffix = "_sides";

/// Returns the name of the part of a boundary that an offset takes to its partners, in every
/// format: "seam_1_0", in space "seam_0_-1_0".
std::string seam_name(std::span<const int> offset);
template <class Offset>
requires requires(const Offset& offset) { offset.components(); }
std::string seam_name(const Offset& offset) {
    const auto numbers = offset.components();
    return seam_name(std::span<const int>(numbers));
}

/// Returns the side of the domain with this name, "wall_left", or nullptr.
constexpr const WallSideRow* find_wall_side(std::string_view name) {
    return find_row(kWallSides, [name](const WallSideRow& row) { return row.word == name; });
}

/// The form of a name: a word; a word before a number; before numbers joined by _; before the name
/// of a phase.
enum class SetForm { kWord, kNumber, kOffset, kPhase };

/// One row of the table of names.
struct SetName {
    std::string_view word;
    SetForm form;
    /// The members of the set, for messages.
    std::string_view meaning;
};

/// All names but those of walls (kWallSides) and of their sides.
std::span<const SetName> set_names();

/// The set of a file that a name means, without regard to case: "cell_3, the elements of a cell".
/// `nullopt` for a name that no writer uses.
///
/// Example usage:
///     if (const auto set = set_with_name(tag, phases)) throw InvalidInput(tag + " is " + *set);
///
/// @param names  of all phases and tags of the run, which name sets themselves.
std::optional<std::string> set_with_name(std::string_view name,
                                         const std::vector<std::string>& names);

/// Requires that a phase or a tag does not have the name of a set in files.
/// @param kind  what has the name, in words: "the phase".
/// @throws InvalidInput naming the set.
void require_free_name(const std::string& kind, const std::string& name,
                       const std::vector<std::string>& names);

}  // namespace pcvt
