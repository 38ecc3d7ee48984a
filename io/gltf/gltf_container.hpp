#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// The containers of glTF: `.gltf` with an embedded buffer, or binary `.glb`.
enum class GltfContainer { kText, kBinary };

/// The version of the container, and the bytes before its first chunk and before each chunk's data.
inline constexpr std::uint32_t kGlbVersion = 2;
inline constexpr std::size_t kGlbHeaderSize = 12;
inline constexpr std::size_t kGlbChunkHeaderSize = 8;

/// Returns a .glb file with its JSON and its one buffer; both chunks are padded to a multiple of
/// four bytes.
std::string glb_bytes(std::string_view json, const std::vector<unsigned char>& buffer);

/// Appends the buffer as the data URI that embeds it in a .gltf file.
void append_data_uri(std::string& text, const std::vector<unsigned char>& buffer);

}  // namespace pcvt
