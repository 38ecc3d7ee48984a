#pragma once

#include <string>

#include "mesher/base/choices.hpp"
#include "mesher/base/error.hpp"
#include "plugin/abi/option_values.hpp"
#include "plugin/abi/struct_fields.hpp"
#include "plugin/job/features.hpp"
#include "plugin/job/number_options.hpp"
#include "plugin/job/option_fields.hpp"

namespace pcvt::abi {

/// Requires that the fields of features which jobs of a dimension lack have their defaults.
///
/// Example usage:
///   require_default_fields(kOptionFields, options, default_options(), &FeatureRow::in_space,
///                          "is not for three dimensions");
///
/// @param of_dimension  FeatureRow::in_plane or in_space.
/// @param why           the end of the message.
/// @throws InvalidInput naming the first field of another value.
template <class Fields, class Struct>
void require_default_fields(const Fields& fields, const Struct& given, const Struct& defaults,
                            bool FeatureRow::*of_dimension, const char* why) {
    for (const StructField<Struct>& field : fields) {
        const FeatureRow* const feature = find_field(field.name);
        if (feature == nullptr || feature->*of_dimension) continue;
        if (field.differs(given, defaults)) throw InvalidInput(std::string(field.name) + " " + why);
    }
}

/// The number of a field as the option that it belongs to takes it.
/// @returns false where the field leaves the option at its default.
/// @throws InvalidInput naming the field.
template <class Number>
bool is_set(const NumberRow& row, Number value) {
    const char* const name = row.field.c_str();
    if constexpr (std::is_floating_point_v<Number>) require_finite(name, &value, 1);
    if (row.unset == UnsetField::kNone) return true;
    if (value >= 0) return value > 0 || row.unset == UnsetField::kNegative;
    if (row.unset == UnsetField::kNegative) return false;
    throw InvalidInput(row.field + " is negative; take 0 or " +
                       (row.is_whole() ? "more" : "a length"));
}

/// Sets the options that one number of a struct states, by their table.
/// @param target  a Job, or a FileOptions for a struct of files.
/// @throws InvalidInput naming the field.
template <class Fields, class Struct, class Target>
void read_numbers(const Fields& fields, const Struct& given, Target& target) {
    for (const NumberRow& row : number_options()) {
        const auto* const field =
            find_row(fields, [&](const StructField<Struct>& f) { return f.name == row.field; });
        if (field == nullptr) continue;
        if (const auto* const real = std::get_if<double Struct::*>(&field->number)) {
            if (is_set(row, given.*(*real))) set_number(row, target, given.*(*real));
        } else if (const auto* const whole = std::get_if<std::int32_t Struct::*>(&field->number)) {
            if (is_set(row, given.*(*whole))) set_number(row, target, given.*(*whole));
        }
    }
}

}  // namespace pcvt::abi
