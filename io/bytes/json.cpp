#include "io/bytes/json.hpp"

#include <algorithm>
#include <charconv>
#include <functional>

#include "io/bytes/text.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt {

void Json::MembersDeleter::operator()(std::vector<JsonMember>* members) const noexcept {
    delete members;
}

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
constexpr std::string_view kHexDigits = "0123456789abcdef";
/// The escapes of one letter, and the characters that they mean.
constexpr std::string_view kEscapes = "\"\\/bfnrt";
constexpr std::string_view kEscaped = "\"\\/\b\f\n\r\t";

const char* words(JsonFault::Kind kind) {
    switch (kind) {
        case JsonFault::Kind::kNumberTooLarge:
            return "a number in the JSON is too large";
        case JsonFault::Kind::kTooDeep:
            return "the JSON is nested too deeply";
        case JsonFault::Kind::kSyntax:
            break;
    }
    return "not JSON";
}

bool is_within(unsigned char byte, unsigned char least, unsigned char most) {
    return byte >= least && byte <= most;
}

/// A character of UTF-8 at the beginning of a text.
struct Character {
    /// The length of the character, or of the longest part of one, at least 1.
    std::size_t length;
    bool is_valid;
};

Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return {1, true};
    if (!is_within(lead, 0xC2, 0xF4)) return {1, false};
    const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    // No overlong forms, no surrogates, nothing beyond U+10FFFF: limits of the second byte.
    unsigned char least = 0x80;
    unsigned char most = 0xBF;
    if (lead == 0xE0) least = 0xA0;
    if (lead == 0xED) most = 0x9F;
    if (lead == 0xF0) least = 0x90;
    if (lead == 0xF4) most = 0x8F;
    for (std::size_t k = 1; k < length; ++k) {
        if (k == text.size() || !is_within(byte(k), least, most)) return {k, false};
        least = 0x80;
        most = 0xBF;
    }
    return {length, true};
}

void append_utf8(std::string& text, std::uint32_t code) {
    const auto add = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        add(code);
    } else if (code < 0x800) {
        add(0xC0 | code >> 6);
        add(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        add(0xE0 | code >> 12);
        add(0x80 | (code >> 6 & 0x3F));
        add(0x80 | (code & 0x3F));
    } else {
        add(0xF0 | code >> 18);
        add(0x80 | (code >> 12 & 0x3F));
        add(0x80 | (code >> 6 & 0x3F));
        add(0x80 | (code & 0x3F));
    }
}

}  // namespace

JsonFault::JsonFault(Kind kind, std::size_t byte)
    : InvalidInput(words(kind)), kind_(kind), byte_(byte) {}

/// Descends through one text.
class JsonParser {
   public:
    explicit JsonParser(std::string_view text) : text_(text) {}

    Json whole() {
        if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
        Json json = value(0);
        skip_blanks();
        if (at_ < text_.size()) fail();
        return json;
    }

   private:
    [[noreturn]] void fail(JsonFault::Kind kind = JsonFault::Kind::kSyntax) const {
        throw JsonFault(kind, std::min(at_ + 1, text_.size()));
    }

    /// The next character; NUL, which JSON never contains, at the end of the text.
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool take(char wanted) {
        if (peek() != wanted || at_ == text_.size()) return false;
        ++at_;
        return true;
    }
    void require(char wanted) {
        if (!take(wanted)) fail();
    }
    void skip_blanks() {
        while (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r') ++at_;
    }

    Json value(int depth) {
        skip_blanks();
        Json json;
        switch (peek()) {
            case '{':
                json.value_ = object(depth);
                break;
            case '[':
                json.value_ = list(depth);
                break;
            case '"':
                json.value_ = std::make_unique<const std::string>(string());
                break;
            case 't':
                word("true");
                json.value_ = true;
                break;
            case 'f':
                word("false");
                json.value_ = false;
                break;
            case 'n':
                word("null");
                break;
            default:
                number(json);
        }
        return json;
    }

    void word(std::string_view wanted) {
        for (const char c : wanted) require(c);
    }

    Json::List list(int depth) {
        if (depth == Json::kMaxDepth) fail(JsonFault::Kind::kTooDeep);
        auto entries = std::make_unique<std::vector<Json>>();
        require('[');
        skip_blanks();
        if (take(']')) return entries;
        do {
            checkpoint();
            entries->push_back(value(depth + 1));
            skip_blanks();
        } while (take(','));
        require(']');
        entries->shrink_to_fit();
        return entries;
    }

    Json::Object object(int depth) {
        if (depth == Json::kMaxDepth) fail(JsonFault::Kind::kTooDeep);
        Json::Object members(new std::vector<JsonMember>);
        require('{');
        skip_blanks();
        if (take('}')) return members;
        do {
            skip_blanks();
            std::string name = string();
            skip_blanks();
            require(':');
            members->push_back({std::move(name), value(depth + 1)});
            skip_blanks();
        } while (take(','));
        require('}');
        return members;
    }

    std::string string() {
        require('"');
        std::string text;
        while (!take('"')) {
            if (take('\\')) {
                escape(text);
                continue;
            }
            if (static_cast<unsigned char>(peek()) < 0x20) fail();
            const auto [length, is_valid] = first_character(text_.substr(at_));
            if (!is_valid) fail();
            text += text_.substr(at_, length);
            at_ += length;
        }
        return text;
    }

    void escape(std::string& text) {
        const std::size_t known = kEscapes.find(peek());
        if (at_ < text_.size() && known != std::string_view::npos) {
            ++at_;
            text += kEscaped[known];
            return;
        }
        std::uint32_t code = code_unit();
        const auto is_surrogate = [](std::uint32_t unit, std::uint32_t first) {
            return unit >= first && unit < first + 0x400;
        };
        if (is_surrogate(code, 0xD800)) {
            require('\\');
            const std::uint32_t low = code_unit();
            if (!is_surrogate(low, 0xDC00)) fail();
            code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
        } else if (is_surrogate(code, 0xDC00)) {
            fail();
        }
        append_utf8(text, code);
    }

    /// Takes uXXXX.
    std::uint32_t code_unit() {
        require('u');
        std::uint32_t code = 0;
        for (int k = 0; k < 4; ++k, ++at_) {
            const char c = peek();
            const char lower = c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c;
            const std::size_t digit = kHexDigits.find(lower);
            if (c == '\0' || digit == std::string_view::npos) fail();
            code = code << 4 | static_cast<std::uint32_t>(digit);
        }
        return code;
    }

    bool take_digits() {
        const std::size_t begin = at_;
        while (peek() >= '0' && peek() <= '9') ++at_;
        return at_ > begin;
    }

    void number(Json& json) {
        const std::size_t begin = at_;
        const bool is_negative = take('-');
        if (!take('0') && !take_digits()) fail();
        const bool has_point = take('.');
        if (has_point && !take_digits()) fail();
        bool is_whole = !has_point;
        bool is_small = false;
        if (take('e') || take('E')) {
            is_whole = false;
            is_small = take('-');
            if (!is_small) take('+');
            if (!take_digits()) fail();
        }
        const char* first = text_.data() + begin;
        const char* last = text_.data() + at_;
        const auto fits = [&](auto& number) {
            return std::from_chars(first, last, number).ec == std::errc();
        };
        std::int64_t with_sign = 0;
        std::uint64_t without_sign = 0;
        double real = 0;
        if (is_whole && is_negative && fits(with_sign)) {
            json.value_ = with_sign;
        } else if (is_whole && !is_negative && fits(without_sign)) {
            json.value_ = without_sign;
        } else {
            // Numbers closer to 0 than every double are 0.
            is_small = is_small || first[is_negative ? 1 : 0] == '0';
            const bool is_real = read_decimal(first, last, real).ec == std::errc();
            if (!is_real && !is_small) fail(JsonFault::Kind::kNumberTooLarge);
            json.value_ = real;
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

Json Json::parse(std::string_view text) { return JsonParser(text).whole(); }

std::span<const JsonMember> Json::members() const {
    if (const auto* members = std::get_if<Object>(&value_)) return **members;
    return {};
}

const Json* Json::find(std::string_view name) const {
    const std::span<const JsonMember> all = members();
    for (auto member = all.rbegin(); member != all.rend(); ++member) {
        if (member->name == name) return &member->value;
    }
    return nullptr;
}

std::size_t Json::size() const {
    if (const auto* entries = std::get_if<List>(&value_)) return (*entries)->size();
    return members().size();
}

const Json* Json::begin() const {
    const auto* entries = std::get_if<List>(&value_);
    return entries == nullptr ? nullptr : (*entries)->data();
}

bool Json::same(const Json& other) const {
    if (is_number() && other.is_number()) return get<double>() == other.get<double>();
    if (value_.index() != other.value_.index() || size() != other.size()) return false;
    if (is_string()) return text() == other.text();
    if (holds<bool>()) return std::get<bool>(value_) == std::get<bool>(other.value_);
    if (is_array()) return std::equal(begin(), end(), other.begin(), std::mem_fn(&Json::same));
    return std::all_of(members().begin(), members().end(), [&other](const JsonMember& own) {
        return other.contains(own.name) && own.value.same(*other.find(own.name));
    });
}

void append_json_string(std::string& json, std::string_view text) {
    json += '"';
    while (!text.empty()) {
        const auto [length, is_valid] = first_character(text);
        const auto byte = static_cast<unsigned char>(text.front());
        // The escape of "/" is never needed.
        const std::size_t known = byte == '/' ? std::string_view::npos : kEscaped.find(text[0]);
        if (!is_valid) {
            json += kReplacement;
        } else if (known != std::string_view::npos) {
            json += {'\\', kEscapes[known]};
        } else if (byte < 0x20) {
            json.append("\\u00") += {kHexDigits[byte >> 4], kHexDigits[byte & 15]};
        } else {
            json += text.substr(0, length);
        }
        text.remove_prefix(length);
    }
    json += '"';
}

}  // namespace pcvt
