#include "io/gltf_container.hpp"

#include <algorithm>
#include <cstdint>

namespace pcvt {
namespace {

constexpr std::size_t kHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;
constexpr std::uint32_t kVersion = 2;
constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

/// Little-endian.
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
        kHeaderSize + 2 * kChunkHeaderSize + padded(json.size()) + padded(binary.size());
    std::string bytes;
    bytes.reserve(size);
    bytes += "glTF";
    append_word(bytes, kVersion);
    append_word(bytes, size);
    append_chunk(bytes, "JSON", json, ' ');
    append_chunk(bytes, std::string_view("BIN\0", 4), binary, '\0');
    return bytes;
}

std::string data_uri(const std::vector<unsigned char>& buffer) {
    std::string uri = "data:application/octet-stream;base64,";
    const std::size_t head = uri.size();
    uri.resize(head + (buffer.size() + 2) / 3 * 4, '=');
    char* digit = uri.data() + head;
    for (std::size_t k = 0; k < buffer.size(); k += 3) {
        const std::size_t n = std::min<std::size_t>(3, buffer.size() - k);
        std::uint32_t group = 0;
        for (std::size_t l = 0; l < 3; ++l) group = group << 8 | (l < n ? buffer[k + l] : 0U);
        for (std::size_t l = 0; l <= n; ++l) digit[l] = kDigits[group >> (18 - 6 * l) & 63];
        digit += 4;
    }
    return uri;
}

}  // namespace pcvt
