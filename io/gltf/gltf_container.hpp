#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// A .glb file from its JSON and its one buffer; both chunks are padded to whole words.
std::string glb_bytes(std::string_view json, const std::vector<unsigned char>& buffer);

/// Appends the buffer as the URI in which a .gltf file carries it.
void append_data_uri(std::string& text, const std::vector<unsigned char>& buffer);

}  // namespace pcvt
