#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// A .glb file from its JSON and its one buffer; both chunks are padded to whole words.
std::string glb_bytes(std::string_view json, const std::vector<unsigned char>& buffer);

/// The buffer as the URI in which a .gltf file carries it.
std::string data_uri(const std::vector<unsigned char>& buffer);

}  // namespace pcvt
