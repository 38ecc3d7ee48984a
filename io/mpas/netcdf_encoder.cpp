#include "io/mpas/netcdf_encoder.hpp"

#include <Eigen/Core>

namespace pcvt {
namespace {

constexpr std::string_view kMagic = "CDF\x02";
constexpr std::size_t kTextPadding = 4;
/// Begin the lists of a header.
constexpr std::uint32_t kDimensionList = 10;
constexpr std::uint32_t kVariableList = 11;
constexpr std::uint32_t kAttributeList = 12;

/// Appends a number, big-endian.
template <class Number>
void append_number(std::string& bytes, Number number) {
    for (int shift = 8 * (int(sizeof number) - 1); shift >= 0; shift -= 8) {
        bytes += static_cast<char>(number >> shift & 0xff);
    }
}

/// Appends the length of a text, the text and its padding.
void append_text(std::string& bytes, std::string_view text) {
    append_number(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += text;
    bytes.append((kTextPadding - text.size() % kTextPadding) % kTextPadding, '\0');
}

/// Appends the head of a list.
void append_list(std::string& bytes, std::uint32_t tag, std::size_t n_entries) {
    append_number(bytes, n_entries == 0 ? 0 : tag);
    append_number(bytes, static_cast<std::uint32_t>(n_entries));
}

void append_attribute(std::string& bytes, std::string_view name, std::string_view text) {
    append_text(bytes, name);
    append_number(bytes, static_cast<std::uint32_t>(NetcdfType::kText));
    append_text(bytes, text);
}

}  // namespace

void NetcdfEncoder::add_dimension(std::string_view name, std::uint32_t size) {
    append_text(dimensions_, name);
    append_number(dimensions_, size);
    ++n_dimensions_;
}

void NetcdfEncoder::add_attribute(std::string_view name, std::string_view text) {
    append_attribute(attributes_, name, text);
    ++n_attributes_;
}

void NetcdfEncoder::add_attribute(std::string_view name, double number) {
    append_text(attributes_, name);
    append_number(attributes_, static_cast<std::uint32_t>(NetcdfType::kDouble));
    append_number(attributes_, std::uint32_t{1});
    append_number(attributes_, Eigen::numext::bit_cast<std::uint64_t>(number));
    ++n_attributes_;
}

void NetcdfEncoder::add_variable(std::string_view name, NetcdfType type,
                                 const std::vector<std::uint32_t>& dimensions,
                                 std::uint64_t n_bytes, const std::vector<Attribute>& attributes) {
    std::string definition;
    append_text(definition, name);
    append_number(definition, static_cast<std::uint32_t>(dimensions.size()));
    for (const std::uint32_t dimension : dimensions) append_number(definition, dimension);
    append_list(definition, kAttributeList, attributes.size());
    for (const auto& [key, text] : attributes) append_attribute(definition, key, text);
    append_number(definition, static_cast<std::uint32_t>(type));
    append_number(definition, static_cast<std::uint32_t>(n_bytes));
    variables_.push_back({std::move(definition), n_bytes});
}

void NetcdfEncoder::append(const std::vector<int>& values) {
    for (const int value : values) append_number(values_, static_cast<std::uint32_t>(value));
}

void NetcdfEncoder::append(const std::vector<double>& values) {
    for (const double value : values)
        append_number(values_, Eigen::numext::bit_cast<std::uint64_t>(value));
}

std::string NetcdfEncoder::bytes() && {
    std::string bytes(kMagic);
    append_number(bytes, std::uint32_t{0});  // records
    append_list(bytes, kDimensionList, n_dimensions_);
    bytes += dimensions_;
    append_list(bytes, kAttributeList, n_attributes_);
    bytes += attributes_;
    append_list(bytes, kVariableList, variables_.size());
    // The values begin behind the header, which holds 64 bits for the beginning of each variable.
    std::uint64_t begin = bytes.size();
    for (const Variable& variable : variables_) begin += variable.definition.size() + sizeof begin;
    bytes.reserve(static_cast<std::size_t>(begin) + values_.size());
    for (const Variable& variable : variables_) {
        bytes += variable.definition;
        append_number(bytes, begin);
        begin += variable.n_bytes;
    }
    return bytes += values_;
}

}  // namespace pcvt
