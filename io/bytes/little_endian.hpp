#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pcvt {

/// Appends an unsigned number, the lowest byte first.
///
/// Example usage:
///     append_little_endian(bytes, 258, 4);  // "\2\1\0\0"
inline void append_little_endian(std::string& bytes, std::uint64_t value, int n_bytes) {
    for (int k = 0; k < n_bytes; ++k) bytes += static_cast<char>(value >> 8 * k & 0xff);
}

/// The unsigned number of at most 8 bytes.
inline std::uint64_t little_endian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        value |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << 8 * k;
    }
    return value;
}

}  // namespace pcvt
