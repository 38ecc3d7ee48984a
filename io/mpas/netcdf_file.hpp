#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// The types of values that pcvt writes, by their numbers in a file.
enum class NetcdfType : std::uint32_t { kText = 2, kInt = 4, kDouble = 6 };

/// A netCDF file of a classic format (CDF-1, CDF-2, CDF-5), for reading. Arbitrary bytes give
/// values or BadFile; every count is compared with the length of the file before memory is
/// allocated.
///
/// Example usage:
///     const NetcdfFile file("mesh.nc", bytes);
///     const std::size_t n = file.dimension("nCells");
///     const std::vector<double> x = file.numbers("xCell", {n});
class NetcdfFile {
   public:
    /// Reads the header.
    /// @param path   of the file, for messages.
    /// @param bytes  must outlive this object.
    NetcdfFile(std::string path, std::string_view bytes);

    /// @throws BadFile `path: complaint`.
    [[noreturn]] void throw_bad_file(const std::string& complaint) const;

    // Each of these throws BadFile if the name is missing, or the type or the size is another.

    std::size_t dimension(std::string_view name) const;
    bool has_attribute(std::string_view name) const;
    /// Returns an attribute of the file that is a text.
    std::string_view text(std::string_view name) const;
    /// Returns an attribute of a variable that is a text; empty if it has none.
    std::string_view text_of(std::string_view variable, std::string_view name) const;
    /// Returns an attribute of the file that is one number.
    double attribute(std::string_view name) const;
    /// Returns the values of a variable of these dimensions, row by row.
    std::vector<int> integers(std::string_view name, const std::vector<std::size_t>& size) const;
    std::vector<double> numbers(std::string_view name, const std::vector<std::size_t>& size) const;

   private:
    friend class NetcdfHeaderScanner;
    struct Dimension {
        std::string_view name;
        std::uint64_t size;
    };
    /// Values of one type from the byte `begin` on.
    struct Values {
        std::string_view name;
        std::uint32_t type = 0;
        std::uint64_t count = 0;
        std::uint64_t begin = 0;
    };
    struct Variable {
        Values values;
        /// Indices of dimensions.
        std::vector<std::uint64_t> dimensions;
        std::vector<Values> attributes;
    };

    template <class Entries>
    const auto& find(const Entries& entries, std::string_view name) const;
    double number(const Values& values, std::uint64_t k) const;
    const Variable& variable(std::string_view name, const std::vector<std::size_t>& size) const;

    std::string path_;
    std::string_view bytes_;
    std::vector<Dimension> dimensions_;
    std::vector<Values> attributes_;
    std::vector<Variable> variables_;
};

}  // namespace pcvt
