#include "io/voxels/zlib_blocks.hpp"

#include <zlib.h>

#include <new>

namespace pcvt {
namespace {

/// zlib takes no pointers to const, but does not write there.
Bytef* input(std::string_view bytes) {
    return reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
}

}  // namespace

std::string zlib_compressed(std::string_view bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string packed(size, '\0');
    // The only fault that remains is a lack of memory.
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, input(bytes),
                  static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION) != Z_OK) {
        throw std::bad_alloc();
    }
    packed.resize(size);
    return packed;
}

bool zlib_decompress(std::string_view packed, std::size_t size, std::string& bytes) {
    const std::size_t head = bytes.size();
    bytes.resize(head + size);
    uLongf written = static_cast<uLongf>(size);
    uLong read = static_cast<uLong>(packed.size());
    const int status =
        uncompress2(reinterpret_cast<Bytef*>(bytes.data() + head), &written, input(packed), &read);
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    return status == Z_OK && written == size && read == packed.size();
}

}  // namespace pcvt
