#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcvt::testing {

inline std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
}

inline std::string png_chunk(const std::string& type, const std::string& data) {
    const std::string body = type + data;
    const auto sum =
        crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return big_endian(static_cast<std::uint32_t>(data.size())) + body +
           big_endian(static_cast<std::uint32_t>(sum));
}

inline std::string deflated(const std::string& data) {
    uLongf size = compressBound(data.size());
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
             reinterpret_cast<const Bytef*>(data.data()), data.size());
    packed.resize(size);
    return packed;
}

struct PngHeader {
    std::uint32_t width;
    std::uint32_t height;
    int depth = 8;
    /// 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGB and alpha.
    int colour = 0;
};

inline std::string png_signature() { return "\x89PNG\r\n\x1a\n"; }

inline std::string png_header(const PngHeader& h) {
    return png_chunk("IHDR", big_endian(h.width) + big_endian(h.height) +
                                 static_cast<char>(h.depth) + static_cast<char>(h.colour) +
                                 std::string(3, '\0'));
}

/// Encodes rows of packed samples as a PNG; `before` holds chunks between header and pixels.
inline std::string png_bytes(const PngHeader& header, const std::vector<std::string>& rows,
                             const std::string& before = "") {
    std::string pixels;
    for (const std::string& row : rows) pixels += '\0' + row;
    return png_signature() + png_header(header) + before + png_chunk("IDAT", deflated(pixels)) +
           png_chunk("IEND", "");
}

}  // namespace pcvt::testing
