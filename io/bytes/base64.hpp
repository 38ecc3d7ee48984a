#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// Whole groups of four digits, padded with `=` (RFC 4648, section 4).
void append_base64(std::string& text, const std::vector<unsigned char>& bytes);

/// How many characters at the beginning of `text` are digits or padding.
std::size_t base64_length(std::string_view text);

/// False unless `text` is whole groups of four digits, padded with `=`.
bool decode_base64(std::string_view text, std::string& bytes);

}  // namespace pcvt
