#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/run_files/angle_columns.hpp"

namespace pcvt {

/// The head of a list of orientations that a program for textures wrote. Its rows have the angles
/// and the weight in columns 1 to 4.
struct ListHead {
    /// The number of rows that it states.
    std::int64_t n_rows = 0;
    /// kGuessed where the head states none.
    AngleUnit unit = AngleUnit::kGuessed;
    /// The text with blanks in place of the head, so that its lines keep their numbers.
    std::string rows;
};

/// Finds one of these heads:
///   DREAM.3D (StatsGenerator): comments, of which one may state the unit, then "Angle Count:N";
///   VPSC, as MTEX writes it: three lines of any text, then "B N".
///
/// Example usage:
///     const std::optional<ListHead> head = list_head("texture.tex", text);
///     TableScanner scanner("texture.tex", head ? head->rows : text);
///
/// @throws BadFile for a list of VPSC whose angles are not Bunge's.
std::optional<ListHead> list_head(const std::string& name, std::string_view text);

}  // namespace pcvt
