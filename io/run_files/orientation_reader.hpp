#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesher/materials/cell_materials.hpp"

namespace pcvt {

/// Reads Bunge's angles phi1, Phi and phi2, in degrees from -360 to 360, one line a site. As
/// files of sites may, the file may hold blank lines, comments after a #, CRLF and tabs.
///
/// Example usage:
///     choices.orientations = read_orientations("angles.txt");
///
/// @throws BadFile with the line for any other text, and for a text without an orientation.
std::vector<BungeAngles> parse_orientations(const std::string& name, std::string_view text);

/// Reads a file. @throws BadFile, LimitExceeded
std::vector<BungeAngles> read_orientations(const std::string& path);

}  // namespace pcvt
