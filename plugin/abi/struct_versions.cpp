#include "plugin/abi/struct_versions.hpp"

#include <string>

namespace pcvt::abi {

void check_struct_size(const char* name, std::size_t size, std::size_t oldest) {
    // Fields are appended in multiples of eight bytes.
    if (size < oldest || size > kLargestStruct || size % alignof(double) != 0) {
        throw AbiMismatch(std::string(name) + " has size " + std::to_string(size) +
                          " in place of " + std::to_string(oldest) +
                          "; build the host with the header of this pcvt");
    }
}

void throw_unknown_fields(const char* name) {
    throw AbiMismatch(std::string(name) +
                      " has fields that this pcvt does not know; take a newer one");
}

bool uses_reserved_fields(const pcvt_options& options) {
    return options.reserved != 0 || options.reserved2 != 0 || options.reserved3 != 0 ||
           options.reserved4 != 0 || options.reserved5 != 0 || options.reserved6 != 0;
}

bool uses_reserved_fields(const pcvt_write_options& options) { return options.reserved2 != 0; }

void check_tail(const char* name, const void* begin, std::size_t size, std::size_t known) {
    const char* bytes = static_cast<const char*>(begin);
    if (std::any_of(bytes + known, bytes + size, [](char byte) { return byte != 0; })) {
        throw_unknown_fields(name);
    }
}

void check_version(std::uint32_t host) {
    constexpr std::uint32_t own = PCVT_ABI_VERSION;
    const bool same_major = host >> 16 == own >> 16;
    const bool fits = own >> 16 == 0 ? host == own : host <= own;
    if (same_major && fits) return;
    const auto text = [](std::uint32_t version) {
        return std::to_string(version >> 16) + "." + std::to_string(version & 0xFFFFU);
    };
    throw AbiMismatch("the host was built for interface " + text(host) + ", this library has " +
                      text(own) + "; build the host with the header of this pcvt");
}

}  // namespace pcvt::abi
