#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "io/bytes/text.hpp"

namespace pcvt {

/// How the entries of a list or the members of an object are set out.
struct JsonLayout {
    std::string_view before_first = "";
    std::string_view between = ", ";
    std::string_view after_last = "";
    std::string_view after_key = ": ";
    /// Entries a line; `line_break` follows the last one in place of `between`. 0: `between`
    /// separates all entries.
    std::size_t per_line = 0;
    std::string_view line_break = "";
};

/// [1, 2] and {"a": 1}
inline constexpr JsonLayout kSpacedJson{};
/// [1,2] and {"a":1}
inline constexpr JsonLayout kCompactJson{.between = ",", .after_key = ":"};
/// An object with one member a line.
inline constexpr JsonLayout kJsonLines{
    .before_first = "\n  ", .between = ",\n  ", .after_last = "\n"};

/// Which characters of a text are escaped: those that JSON requires, or those that end a script of
/// a page as well.
enum class JsonEscapes { kPlain, kInPage };

/// Appends JSON to a text. Numbers are the shortest decimals that read back.
///
/// Example usage:
///     std::string text;
///     JsonWriter json(text);
///     json.begin_object(kJsonLines);
///     json.member("sites", 64);
///     json.member("lattice", std::array{std::array{1.0, 0.0}, std::array{0.0, 1.0}});
///     json.end();  // {"sites": 64, "lattice": [[1, 0], [0, 1]]}, one member a line
///
/// The caller begins and ends lists and objects in pairs, and gives each member of an object a key.
/// @throws InternalError if a number is not finite.
class JsonWriter {
   public:
    /// @param text    must outlive the writer.
    /// @param layout  of lists and objects that begin without one.
    explicit JsonWriter(std::string& text, const JsonLayout& layout = kSpacedJson,
                        JsonEscapes escapes = JsonEscapes::kPlain)
        : text_(text), layout_(layout), escapes_(escapes) {}

    void begin_list() { begin_list(layout_); }
    void begin_list(const JsonLayout& layout) { begin('[', ']', layout); }
    void begin_object() { begin_object(layout_); }
    void begin_object(const JsonLayout& layout) { begin('{', '}', layout); }
    /// Ends the innermost list or object.
    void end();
    /// Sets out the entries that follow in the innermost list or object.
    void set_layout(const JsonLayout& layout) { levels_.back().layout = layout; }

    /// The key of the value that follows.
    void key(std::string_view name);

    /// Appends a number, a text, true or false, null for no value, a list for a range.
    template <class Value>
    void value(const Value& value) {
        if constexpr (std::is_same_v<Value, bool>) {
            raw(value ? "true" : "false");
        } else if constexpr (std::integral<Value>) {
            raw(std::to_string(value));
        } else if constexpr (std::floating_point<Value>) {
            separate();
            append_number(text_, value);
        } else if constexpr (std::convertible_to<const Value&, std::string_view>) {
            separate();
            append_string(value);
        } else if constexpr (requires { value.has_value(); }) {
            value ? this->value(*value) : raw("null");
        } else {
            values(value, layout_);
        }
    }
    /// Appends a list of values.
    template <class Values>
    void values(const Values& values, const JsonLayout& layout) {
        begin_list(layout);
        for (const auto& value : values) this->value(value);
        end();
    }
    /// Appends a value that is JSON already.
    void raw(std::string_view json);

    template <class Value>
    void member(std::string_view name, const Value& value) {
        key(name);
        this->value(value);
    }
    /// Appends a member that is an object; `append_members` appends its members.
    template <class AppendMembers>
    void object(std::string_view name, const AppendMembers& append_members) {
        key(name);
        begin_object();
        append_members();
        end();
    }
    /// Appends a member that is a list; `append_entry` appends an entry of the list.
    template <class Entries, class AppendEntry>
    void list(std::string_view name, const Entries& entries, const AppendEntry& append_entry) {
        key(name);
        begin_list();
        for (const auto& entry : entries) append_entry(entry);
        end();
    }

   private:
    /// A list or an object that has not ended.
    struct Level {
        JsonLayout layout;
        char closing;
        std::size_t n_entries = 0;
    };

    void begin(char opening, char closing, const JsonLayout& layout);
    /// Begins an entry of the innermost list or object, unless it is the value of a key.
    void separate();
    void append_string(std::string_view string);

    std::string& text_;
    JsonLayout layout_;
    JsonEscapes escapes_;
    std::vector<Level> levels_ = {};
    bool follows_key_ = false;
};

}  // namespace pcvt
