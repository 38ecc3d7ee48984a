#include "io/voxels/vtk_array.hpp"

#include <algorithm>

#include "io/bytes/base64.hpp"
#include "io/bytes/little_endian.hpp"
#include "io/voxels/zlib_blocks.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// The length in base64 of `n_bytes` bytes, padded to complete groups of four digits.
std::size_t n_digits(std::size_t n_bytes) { return (n_bytes + 2) / 3 * 4; }

/// A header with the number of bytes, then the bytes.
bool decode_plain(std::string_view text, std::size_t header_size, std::size_t n_bytes,
                  std::string& bytes) {
    if (text.size() != n_digits(n_bytes + header_size)) return false;
    if (!decode_base64(text, bytes) || bytes.size() != n_bytes + header_size) return false;
    if (little_endian(std::string_view(bytes).substr(0, header_size)) != n_bytes) return false;
    bytes.erase(0, header_size);
    return true;
}

/// The header and the blocks of compressed data (append_compressed() in vti_writer.cpp).
bool unpack(std::string_view text, std::size_t header_size, std::size_t n_bytes,
            std::string& bytes) {
    std::string header;
    if (text.size() < n_digits(header_size)) return false;
    if (!decode_base64(text.substr(0, n_digits(header_size)), header)) return false;
    const auto entry = [&](std::size_t k) {
        return little_endian(std::string_view(header).substr(k * header_size, header_size));
    };
    if (header.size() < header_size || entry(0) > text.size()) return false;
    const auto n_blocks = static_cast<std::size_t>(entry(0));
    const std::size_t header_digits = n_digits((3 + n_blocks) * header_size);
    if (text.size() < header_digits) return false;
    if (!decode_base64(text.substr(0, header_digits), header)) return false;
    const std::uint64_t block_size = entry(1);
    const std::uint64_t last_size = entry(2) == 0 ? block_size : entry(2);
    // VTK finds the blocks by their size, the last one too.
    if (last_size > block_size) return false;
    std::string packed;
    if (!decode_base64(text.substr(header_digits), packed)) return false;
    std::string_view rest = packed;
    for (std::size_t b = 0; b < n_blocks; ++b) {
        checkpoint();
        const std::uint64_t size = b + 1 == n_blocks ? last_size : block_size;
        if (size > n_bytes - bytes.size() || entry(3 + b) > rest.size()) return false;
        const auto packed_size = static_cast<std::size_t>(entry(3 + b));
        if (!zlib_decompress(rest.substr(0, packed_size), static_cast<std::size_t>(size), bytes)) {
            return false;
        }
        rest.remove_prefix(packed_size);
    }
    return rest.empty() && bytes.size() == n_bytes;
}

}  // namespace

bool decode_vtk_array(std::string_view text, const VtkArrayForm& form, std::size_t n_bytes,
                      std::string& bytes) {
    constexpr std::string_view kBlanks = " \t\r\n";
    bytes.clear();
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    text.remove_suffix(text.size() - std::min(text.find_last_not_of(kBlanks) + 1, text.size()));
    return form.is_compressed ? unpack(text, form.header_size, n_bytes, bytes)
                              : decode_plain(text, form.header_size, n_bytes, bytes);
}

}  // namespace pcvt
