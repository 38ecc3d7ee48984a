#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/bytes/file_fields.hpp"

namespace pcvt {

/// Returns the words of a file of an OpenFOAM case, its header among them, without comments;
/// nothing for a file outside of constant/polyMesh that lacks the comment `kCaseNote`: a user
/// removes it to change the schemes, the times or the initial state.
///
/// Example usage:
///     if (const auto found = foam_fields(path, text)) compare_fields(*found, *foam_fields(path,
///     expected));
std::optional<FileFields> foam_fields(const std::string& name, std::string_view text);

}  // namespace pcvt
