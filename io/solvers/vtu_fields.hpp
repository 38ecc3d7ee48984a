#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/tiles/file_fields.hpp"

namespace pcvt {

/// Whether SECTION/NAME is an array that encode_vtu() writes.
bool is_vtu_array(std::string_view key);

/// Returns the fields of a VTU: the counts of its piece, and for each array that encode_vtu()
/// writes its type, the numbers of its components and tuples, and its values. The positions of
/// points are left out, because they are proved as those of the tile, and so are arrays of other
/// programs.
///
/// Example usage:
///     compare_fields(*vtu_fields(path, text), *vtu_fields(path, expected_text));
///
/// @throws BadFile  if the text is not XML.
std::optional<FileFields> vtu_fields(const std::string& name, std::string_view text);

}  // namespace pcvt
