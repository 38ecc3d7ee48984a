#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/bytes/file_fields.hpp"

namespace pcvt {

/// Returns the fields of an MSH file: the rows of each section that encode_msh() writes, among the
/// views those of the name "cell_id", by rising number. $Comments and sections of other programs
/// are left out.
///
/// Example usage:
///     compare_fields(*msh_fields(path, text), *msh_fields(path, expected_text));
///
/// @throws BadFile  where a section does not end.
std::optional<FileFields> msh_fields(const std::string& name, std::string_view text);

}  // namespace pcvt
