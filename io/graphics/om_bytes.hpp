#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesher/base/error.hpp"

namespace pcvt {

/// The bytes of an OpenMesh file, little-endian, which are taken from the front.
///
/// Example usage:
///     OmBytes bytes("tile.om", text);
///     const std::string_view magic = bytes.take(4);
///     const std::size_t n_vertices = bytes.read_count();
class OmBytes {
   public:
    /// @param name  of the file, for messages; it must outlive the object, as must the bytes.
    OmBytes(const std::string& name, std::string_view bytes) : name_(name), rest_(bytes) {}

    bool is_at_end() const { return rest_.empty(); }
    /// @throws BadFile if fewer bytes are left.
    std::string_view take(std::size_t n_bytes);
    /// Reads a number without a sign of `width` bytes.
    std::size_t read_size(std::size_t width);
    /// Reads a number of elements. Each element takes at least one byte of the file, so a larger
    /// count is refused before any memory is allocated for it.
    std::size_t read_count();

    /// The signed integer that fills the bytes, at most eight.
    static std::int64_t integer_of(std::string_view bytes);
    /// The number in the first eight bytes.
    static double double_of(std::string_view bytes);

    /// @throws BadFile with the name of the file, the complaint and the remedy.
    [[noreturn]] void throw_bad_file(const std::string& complaint) const;
    /// @throws BadFile with the name of the file and the message of the fault.
    [[noreturn]] void throw_other_fault(const InvalidInput& fault) const;

   private:
    const std::string& name_;
    std::string_view rest_;
};

}  // namespace pcvt
