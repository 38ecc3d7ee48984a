#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/bytes/file_fields.hpp"

namespace pcvt {

/// Returns the fields of an Abaqus input: the data of *ELEMENT and *EQUATION, the numbers of the
/// nodes, and the members of the sets that encode_inp() names, each once by rising number,
/// with the sides of elements on walls. CPE and
/// CPS elements count as equal, because both suit a tile. Sections, orientations and sets of phases
/// count where the file states the materials of its cells. Cards and sets of a user are left out.
///
/// Example usage:
///     compare_fields(*inp_fields(path, text), *inp_fields(path, expected_text));
std::optional<FileFields> inp_fields(const std::string& name, std::string_view text);

/// Returns a word in upper case, as solvers read names.
std::string upper_case(std::string_view text);

}  // namespace pcvt
