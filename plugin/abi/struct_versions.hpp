#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include "mesher/base/error.hpp"
#include "plugin/abi/guard.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// The largest size of a struct that is accepted; a larger number cannot be the size of one.
inline constexpr std::size_t kLargestStruct = 1 << 16;

/// The size of a struct before fields were appended to it, which hosts of older headers of this
/// PCVT_ABI_VERSION have.
template <class Struct>
inline constexpr std::size_t kOldestSize = sizeof(Struct);
template <>
inline constexpr std::size_t kOldestSize<pcvt_options> = offsetof(pcvt_options, duplicates);
template <>
inline constexpr std::size_t kOldestSize<pcvt_statistics> = offsetof(pcvt_statistics, dropped);
template <>
inline constexpr std::size_t kOldestSize<pcvt_cells> = offsetof(pcvt_cells, phases);
template <>
inline constexpr std::size_t kOldestSize<pcvt_write_options> = offsetof(pcvt_write_options,
                                                                        materials);
template <>
inline constexpr std::size_t kOldestSize<pcvt_check_options> = offsetof(pcvt_check_options,
                                                                        volumes);

/// @throws AbiMismatch unless `size` is a multiple of 8 from `oldest` to kLargestStruct.
void check_struct_size(const char* name, std::size_t size, std::size_t oldest);
/// @throws AbiMismatch unless all bytes of a struct after the first `known` ones are zero.
void check_tail(const char* name, const void* begin, std::size_t size, std::size_t known);

/// Whether a host has set a field that later versions may use.
bool uses_reserved_fields(const pcvt_options& options);
bool uses_reserved_fields(const pcvt_write_options& options);
inline bool uses_reserved_fields(const pcvt_check_options& /*options*/) { return false; }
inline bool uses_reserved_fields(const pcvt_study_options& /*options*/) { return false; }
/// @throws AbiMismatch
[[noreturn]] void throw_unknown_fields(const char* name);

/// The struct of the host, in this library's version; fields that the host does not know are zero.
///   const pcvt_options options = read_struct("pcvt_options", given);
/// @throws AbiMismatch as the functions above; InvalidInput for a null pointer.
template <class Struct>
Struct read_struct(const char* name, const Struct* given) {
    if (given == nullptr) throw InvalidInput(std::string(name) + " is a null pointer");
    std::size_t size = 0;
    std::memcpy(&size, given, sizeof size);
    check_struct_size(name, size, kOldestSize<Struct>);
    if (size > sizeof(Struct)) check_tail(name, given, size, sizeof(Struct));
    Struct own{};
    std::memcpy(&own, given, std::min(size, sizeof own));
    if (uses_reserved_fields(own)) throw_unknown_fields(name);
    return own;
}

/// @throws AbiMismatch unless a host of this PCVT_ABI_VERSION may call this library.
void check_version(std::uint32_t host);

}  // namespace pcvt::abi
