#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/cells/cell_materials.hpp"

namespace pcvt {

/// The unit of the angles in a file. kGuessed: degrees, unless they look like radians.
enum class AngleUnit { kGuessed, kDegrees, kRadians };

/// Whether a table of angles looks like radians: it has at least kFewestAngles rows, no angle is
/// above a full turn in radians, no Phi above half a turn, and some angle is above 0.2, so that the
/// crystals are not all turned by less than that many degrees on purpose.
bool look_like_radians(std::span<const BungeAngles> angles);
inline constexpr std::size_t kFewestAngles = 10;

/// Reads Bunge's angles phi1, Phi and phi2 and returns them in degrees, one line a site: from -360
/// to 360 degrees, or from -2 pi to 2 pi. As files of sites may, the file may hold blank lines,
/// comments after a #, CRLF and tabs.
///
/// Example usage:
///     choices.orientations = read_orientations("angles.txt", AngleUnit::kRadians);
///
/// @throws BadFile with the line for any other text; for a text without an orientation; for angles
///         that look like radians, if their unit is guessed.
std::vector<BungeAngles> parse_orientations(const std::string& name, std::string_view text,
                                            AngleUnit unit = AngleUnit::kGuessed);

/// Reads a file. @throws BadFile, LimitExceeded
std::vector<BungeAngles> read_orientations(const std::string& path,
                                           AngleUnit unit = AngleUnit::kGuessed);

}  // namespace pcvt
