#include "io/gltf/gltf_container.hpp"

#include "io/bytes/base64.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kUriHead = "data:application/octet-stream;base64,";
std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

/// Appends 32 bits, little-endian.
void append_word(std::string& bytes, std::size_t value) {
    for (const int shift : {0, 8, 16, 24}) bytes += static_cast<char>(value >> shift & 0xff);
}

void append_chunk(std::string& bytes, std::string_view type, std::string_view content, char fill) {
    append_word(bytes, padded(content.size()));
    bytes.append(type).append(content);
    bytes.append(padded(content.size()) - content.size(), fill);
}

}  // namespace

std::string glb_bytes(std::string_view json, const std::vector<unsigned char>& buffer) {
    const std::string_view binary(reinterpret_cast<const char*>(buffer.data()), buffer.size());
    const std::size_t size =
        kGlbHeaderSize + 2 * kGlbChunkHeaderSize + padded(json.size()) + padded(binary.size());
    std::string bytes;
    bytes.reserve(size);
    bytes += "glTF";
    append_word(bytes, kGlbVersion);
    append_word(bytes, size);
    append_chunk(bytes, "JSON", json, ' ');
    append_chunk(bytes, std::string_view("BIN\0", 4), binary, '\0');
    return bytes;
}

void append_data_uri(std::string& text, const std::vector<unsigned char>& buffer) {
    text += kUriHead;
    append_base64(text, buffer);
}

}  // namespace pcvt
