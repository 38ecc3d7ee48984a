#pragma once

#include <string>
#include <string_view>

namespace pcvt {

/// Returns `bytes` as a stream of zlib (RFC 1950).
///
/// Example usage:
///     const std::string packed = zlib_compressed(bytes);
///     std::string unpacked;
///     const bool whole = zlib_decompress(packed, bytes.size(), unpacked);  // true
///
/// @throws std::bad_alloc if zlib cannot allocate its memory.
std::string zlib_compressed(std::string_view bytes);

/// Appends the content of a stream. Returns false unless it is a stream of `size` bytes and ends
/// where `packed` ends.
/// @throws std::bad_alloc if zlib cannot allocate its memory.
bool zlib_decompress(std::string_view packed, std::size_t size, std::string& bytes);

}  // namespace pcvt
