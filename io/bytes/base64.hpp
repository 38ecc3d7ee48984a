#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// Appends `bytes` to `text` in base64: complete groups of four digits, padded with `=` (RFC 4648,
/// section 4).
///
/// Example usage:
///     std::string text;
///     append_base64(text, {'p', 'c', 'v', 't'});  // text is "cGN2dA=="
///     std::string bytes;
///     decode_base64(text, bytes);  // returns true, and bytes is "pcvt"
void append_base64(std::string& text, const std::vector<unsigned char>& bytes);

/// Returns the number of characters at the beginning of `text` that are base64 digits or padding.
std::size_t base64_length(std::string_view text);

/// Decodes `text` into `bytes`. Returns false unless `text` consists of complete groups of four
/// digits, padded with `=`.
bool decode_base64(std::string_view text, std::string& bytes);

}  // namespace pcvt
