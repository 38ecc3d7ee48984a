#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/mpas/netcdf_file.hpp"

namespace pcvt {

/// Encodes a netCDF file in the 64-bit offset format (CDF-2): first the definitions in any number,
/// then the values of all variables in the order of their definitions.
///
/// Example usage:
///     NetcdfEncoder encoder;
///     encoder.add_dimension("nCells", 2);
///     encoder.add_attribute("x_period", 1.0);
///     encoder.add_variable("xCell", NetcdfType::kDouble, {0}, 2 * sizeof(double));
///     encoder.append(std::vector<double>{0.25, 0.75});
///     output.stage("mesh.nc", std::move(encoder).bytes());
class NetcdfEncoder {
   public:
    /// @param size  0: the unlimited dimension.
    void add_dimension(std::string_view name, std::uint32_t size);
    /// Add an attribute of the file.
    void add_attribute(std::string_view name, std::string_view text);
    void add_attribute(std::string_view name, double number);
    /// A name and a text.
    using Attribute = std::pair<std::string_view, std::string_view>;
    /// @param dimensions  by their order; none is unlimited.
    /// @param n_bytes     of the values, below 2^32.
    void add_variable(std::string_view name, NetcdfType type,
                      const std::vector<std::uint32_t>& dimensions, std::uint64_t n_bytes,
                      const std::vector<Attribute>& attributes = {});

    /// Append the values of the next variable.
    void append(const std::vector<int>& values);
    void append(const std::vector<double>& values);

    std::string bytes() &&;

   private:
    struct Variable {
        std::string definition;
        std::uint64_t n_bytes;
    };
    std::string dimensions_;
    std::uint32_t n_dimensions_ = 0;
    std::string attributes_;
    std::uint32_t n_attributes_ = 0;
    std::vector<Variable> variables_;
    std::string values_;
};

}  // namespace pcvt
