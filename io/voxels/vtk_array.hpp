#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pcvt {

/// How the file of an array in base64 states its length.
struct VtkArrayForm {
    /// The bytes of a number in front of the data: 4 or 8.
    std::size_t header_size = 4;
    /// Whether zlib has compressed the array, in blocks.
    bool is_compressed = false;
};

/// Decodes an inline array of VTK's XML files in base64: its header and its data, compressed or
/// not.
///
/// Example usage:
///     std::string bytes;
///     if (!decode_vtk_array(text, {.header_size = 8, .is_compressed = true}, 4 * n, bytes)) ...
///
/// @param text     blanks around it are skipped.
/// @param n_bytes  of the data, as the rest of the file states them.
/// @param bytes    becomes the data, little-endian.
/// @returns whether the text is such an array of `n_bytes` bytes.
bool decode_vtk_array(std::string_view text, const VtkArrayForm& form, std::size_t n_bytes,
                      std::string& bytes);

}  // namespace pcvt
