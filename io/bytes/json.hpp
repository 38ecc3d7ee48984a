#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "mesher/base/error.hpp"

namespace pcvt {

/// A text that is not JSON, or beyond the limits of Json::parse().
class JsonFault : public InvalidInput {
   public:
    enum class Kind { kSyntax, kNumberTooLarge, kTooDeep };
    JsonFault(Kind kind, std::size_t byte);
    Kind kind() const { return kind_; }
    /// The number of bytes up to and including the first invalid one.
    std::size_t byte() const { return byte_; }

   private:
    Kind kind_;
    std::size_t byte_;
};

struct JsonMember;

/// A value of a JSON text (RFC 8259). In contrast to nlohmann::json no destructor and no move
/// needs memory, so that a program without memory unwinds.
///
/// Example usage:
///     const Json json = Json::parse(R"({"sites": [1, 2]})");
///     if (const Json* sites = json.find("sites")) {
///         for (const Json& site : *sites) use(site.get<int>());
///     }
class Json {
   public:
    /// Lists and objects within each other, at most.
    static constexpr int kMaxDepth = 512;

    /// @throws JsonFault
    static Json parse(std::string_view text);

    bool is_null() const { return holds<std::monostate>(); }
    bool is_array() const { return holds<List>(); }
    bool is_object() const { return holds<Object>(); }
    bool is_string() const { return holds<Text>(); }
    bool is_number() const { return is_number_integer() || holds<double>(); }
    /// Whole numbers without a fraction or an exponent, in 64 bits; unsigned ones have no sign.
    bool is_number_integer() const { return is_number_unsigned() || holds<std::int64_t>(); }
    bool is_number_unsigned() const { return holds<std::uint64_t>(); }

    /// Returns the number, converted. @pre is_number().
    template <class Number>
    Number get() const {
        if (const auto* real = std::get_if<double>(&value_)) return static_cast<Number>(*real);
        if (const auto* whole = std::get_if<std::int64_t>(&value_)) {
            return static_cast<Number>(*whole);
        }
        return static_cast<Number>(std::get<std::uint64_t>(value_));
    }
    /// @pre is_string().
    const std::string& text() const { return *std::get<Text>(value_); }

    /// Returns the value of the last member of this name; null if there is none, or no object.
    const Json* find(std::string_view name) const;
    bool contains(std::string_view name) const { return find(name) != nullptr; }

    /// The number of entries of a list or an object, else 0.
    std::size_t size() const;
    /// @pre is_array() and k < size().
    const Json& operator[](std::size_t k) const { return (*std::get<List>(value_))[k]; }
    /// The entries of a list; none of another value.
    const Json* begin() const;
    const Json* end() const { return begin() + (is_array() ? size() : 0); }
    /// The members of an object, in the order of the text; none of another value.
    std::span<const JsonMember> members() const;

    /// Whether this is the given text, or the given whole number from 0 on.
    bool operator==(std::string_view other) const { return is_string() && text() == other; }
    bool operator==(const char* other) const { return *this == std::string_view(other); }
    template <std::integral Number>
    bool operator==(Number other) const {
        const auto* whole = std::get_if<std::uint64_t>(&value_);
        return whole != nullptr && std::cmp_equal(*whole, other);
    }

    /// Whether both say the same; members may have another order.
    bool same(const Json& other) const;

   private:
    friend class JsonParser;
    // Pointers, so that the many small numbers of a file need 16 bytes each.
    using Text = std::unique_ptr<const std::string>;
    using List = std::unique_ptr<std::vector<Json>>;
    struct MembersDeleter {
        void operator()(std::vector<JsonMember>* members) const noexcept;
    };
    using Object = std::unique_ptr<std::vector<JsonMember>, MembersDeleter>;

    template <class Type>
    bool holds() const {
        return std::holds_alternative<Type>(value_);
    }

    std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, Text, List, Object>
        value_;
};

struct JsonMember {
    std::string name;
    Json value;
};

/// Appends a text in quotes as JSON; the replacement character U+FFFD replaces bytes that are not
/// UTF-8.
void append_json_string(std::string& json, std::string_view text);

}  // namespace pcvt
