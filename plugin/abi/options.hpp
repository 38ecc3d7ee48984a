#pragma once

#include <cstring>

#include "plugin/abi/guard.hpp"
#include "plugin/job/job.hpp"

namespace pcvt::abi {

/// No struct of this interface will ever be larger: a larger size is a wild number.
inline constexpr std::size_t kLargestStruct = 1 << 16;

/// @throws AbiMismatch unless `size` lies between `known` and kLargestStruct.
void check_struct_size(const char* name, std::size_t size, std::size_t known);
/// @throws AbiMismatch unless the bytes of a struct behind the first `known` ones are all zero.
void check_tail(const char* name, const void* begin, std::size_t size, std::size_t known);

/// What the host gave, in our version of the struct.
/// @throws AbiMismatch as the two above; InvalidInput for a null pointer.
template <class Struct>
Struct read_struct(const char* name, const Struct* given) {
    if (given == nullptr) throw InvalidInput(std::string(name) + " is a null pointer");
    std::size_t size = 0;
    std::memcpy(&size, given, sizeof size);
    check_struct_size(name, size, sizeof(Struct));
    check_tail(name, given, size, sizeof(Struct));
    return *given;
}

/// @throws AbiMismatch unless a host of this PCVT_ABI_VERSION may call this library.
void check_version(std::uint32_t host);

pcvt_options default_options();

/// The job that the options describe; the sites are copied.
/// @throws InvalidInput, LimitExceeded naming the field.
Job make_job(const pcvt_options& options);

/// The kind and the outline of numbers of the interface.
/// @throws InvalidInput for what is unknown.
MeshKind tile_kind(std::int32_t kind);
Outline tile_outline(std::int32_t outline);

}  // namespace pcvt::abi
