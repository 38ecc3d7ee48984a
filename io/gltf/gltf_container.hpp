#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// Returns a .glb file with its JSON and its one buffer; both chunks are padded to a multiple of
/// four bytes.
std::string glb_bytes(std::string_view json, const std::vector<unsigned char>& buffer);

/// Appends the buffer as the data URI that embeds it in a .gltf file.
void append_data_uri(std::string& text, const std::vector<unsigned char>& buffer);

}  // namespace pcvt
