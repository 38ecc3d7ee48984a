#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "io/run_files/table_name.hpp"
#include "io/run_files/table_reader.hpp"

namespace pcvt {

/// The unit of the angles in a file. kGuessed: degrees, unless they look like radians.
enum class AngleUnit { kGuessed, kDegrees, kRadians };

/// The columns of phi1, Phi and phi2, and their unit.
struct AngleColumns {
    std::array<std::size_t, 3> columns{0, 1, 2};
    AngleUnit unit = AngleUnit::kGuessed;
};

/// Finds the columns of Bunge's angles: the three that are named; else in a header the columns
/// phi1, Phi and phi2, Euler1 to Euler3, or EulerAngles_0 to EulerAngles_2, in any case, with words
/// such as "mean" or "avg" before or behind; else the first three. The prefix rad or deg of the
/// file and the units of the header (rad, deg, radians, degrees, °) state the unit.
///
/// Example usage:
///     const TableName name = parse_table_name("ebsd.csv", {"rad", "deg"});
///     TableScanner scanner(name.path, text);
///     const AngleColumns angles = find_angles(scanner, name);
///
/// @throws BadFile naming the line of the header and the remedy if no three columns or several ones
///         qualify, and if units contradict each other.
AngleColumns find_angles(TableScanner& scanner, const TableName& name);

}  // namespace pcvt
