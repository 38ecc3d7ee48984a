#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/run_files/table_name.hpp"
#include "mesher/cells/cell_materials.hpp"

namespace pcvt {

/// Whether a table of angles looks like radians: it has at least kFewestAngles rows, no angle is
/// above a full turn in radians, no Phi above half a turn, and some angle is above 0.2, so that the
/// crystals are not all turned by less than that many degrees on purpose.
bool look_like_radians(std::span<const BungeAngles> angles);
inline constexpr std::size_t kFewestAngles = 10;

/// Reads [rad:|deg:]FILE[:COLUMN,COLUMN,COLUMN].
TableName orientation_table(const std::string& text);

/// Bunge's angles of a table, in degrees.
struct OrientationTable {
    std::vector<BungeAngles> angles;
    /// One a row, not negative, with a positive sum; empty if the table has none.
    std::vector<double> weights = {};
    /// The file, for a summary, with the column of the weights: "odf.csv by column weight".
    std::string source = {};
};

/// Reads Bunge's angles phi1, Phi and phi2, one row an orientation: from -360 to 360 degrees, or
/// from -2 pi to 2 pi. The text is a table as TableScanner takes it, with the columns and the unit
/// that find_angles() finds, or a list with a ListHead. A fourth named column holds weights, or the
/// column of the header that is called weight, weights, or volume fraction; but not in a table with
/// a column x, as --cells writes, where weights are those of power cells.
///
/// Example usage:
///     choices.orientations = read_orientations(orientation_table("rad:angles.txt")).angles;
///
/// @throws BadFile with the line for any other text; for a text without an orientation; for angles
///         that look like radians, if their unit is not stated.
OrientationTable parse_orientations(const TableName& name, std::string_view text);

/// Reads a file. @throws BadFile, LimitExceeded
OrientationTable read_orientations(const TableName& name);

}  // namespace pcvt
