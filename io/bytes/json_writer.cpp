#include "io/bytes/json_writer.hpp"

#include <utility>

#include "io/bytes/json.hpp"

namespace pcvt {
namespace {

/// Appends a text in quotes without the characters that end a script or a text of HTML.
void append_page_string(std::string& json, std::string_view text) {
    constexpr std::string_view kDigitsOfByte = "0123456789abcdef";
    constexpr std::string_view kPageMarks = "\"\\<>&";
    json += '"';
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && kPageMarks.find(c) == std::string_view::npos) {
            json += c;
        } else {
            json.append("\\u00") += {kDigitsOfByte[byte / 16], kDigitsOfByte[byte % 16]};
        }
    }
    json += '"';
}

}  // namespace

void JsonWriter::begin(char opening, char closing, const JsonLayout& layout) {
    separate();
    text_ += opening;
    levels_.push_back({layout, closing});
}

void JsonWriter::end() {
    text_ += levels_.back().layout.after_last;
    text_ += levels_.back().closing;
    levels_.pop_back();
}

void JsonWriter::key(std::string_view name) {
    separate();
    append_string(name);
    text_ += levels_.back().layout.after_key;
    follows_key_ = true;
}

void JsonWriter::raw(std::string_view json) {
    separate();
    text_ += json;
}

void JsonWriter::separate() {
    if (std::exchange(follows_key_, false) || levels_.empty()) return;
    auto& [layout, closing, n_entries] = levels_.back();
    const bool breaks = layout.per_line > 0 && n_entries % layout.per_line == 0;
    text_ += n_entries == 0 ? layout.before_first : breaks ? layout.line_break : layout.between;
    ++n_entries;
}

void JsonWriter::append_string(std::string_view string) {
    if (escapes_ == JsonEscapes::kInPage) {
        append_page_string(text_, string);
    } else {
        append_json_string(text_, string);
    }
}

}  // namespace pcvt
