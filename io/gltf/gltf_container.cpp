#include "io/gltf/gltf_container.hpp"

#include "io/bytes/base64.hpp"
#include "io/bytes/little_endian.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kUriHead = "data:application/octet-stream;base64,";
std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

void append_chunk(std::string& bytes, std::string_view type, std::string_view content, char fill) {
    append_little_endian(bytes, padded(content.size()), 4);
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
    append_little_endian(bytes, kGlbVersion, 4);
    append_little_endian(bytes, size, 4);
    append_chunk(bytes, "JSON", json, ' ');
    append_chunk(bytes, std::string_view("BIN\0", 4), binary, '\0');
    return bytes;
}

void append_data_uri(std::string& text, const std::vector<unsigned char>& buffer) {
    text += kUriHead;
    append_base64(text, buffer);
}

}  // namespace pcvt
