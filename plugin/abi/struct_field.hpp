#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>

namespace pcvt::abi {

template <class Value>
bool differ(const Value& one, const Value& other) {
    return one != other;
}
template <class Value, std::size_t n>
bool differ(const Value (&one)[n], const Value (&other)[n]) {
    return !std::equal(one, one + n, other);
}

/// A field of a struct of pcvt.h.
template <class Struct>
struct StructField {
    const char* name;
    /// Whether two structs differ in the field.
    bool (*differs)(const Struct& one, const Struct& other);
    /// The field, if it is one number.
    std::variant<std::monostate, double Struct::*, std::int32_t Struct::*> number = {};
};

template <auto kField, class Struct>
bool differ_in(const Struct& one, const Struct& other) {
    return differ(one.*kField, other.*kField);
}

template <auto kField, class Struct, class Value>
constexpr StructField<Struct> field_of(const char* name, Value Struct::* /*type*/) {
    if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::int32_t>) {
        return {name, differ_in<kField, Struct>, kField};
    } else {
        return {name, differ_in<kField, Struct>};
    }
}

/// The row of a field: struct_field<&pcvt_options::tolerance>("tolerance").
template <auto kField>
constexpr auto struct_field(const char* name) {
    return field_of<kField>(name, kField);
}

}  // namespace pcvt::abi
