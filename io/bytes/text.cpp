#include "io/bytes/text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "io/bytes/char_set.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kMostQuoted = 40;
constexpr CharSet kBlanks(" \t\v\f");
constexpr CharSet kLineEnds("\r\n");
constexpr CharSet kWordEnds(" \t\v\f\r\n");
constexpr std::array<std::string_view, 2> kUtf16Marks{"\xFF\xFE", "\xFE\xFF"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_plus(std::string_view word) {
    const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
    return plus ? word.substr(1) : word;
}

/// Recognizes NaN and infinity, which read_decimal() accepts as numbers.
bool spells_no_finite_number(std::string_view word) {
    const std::size_t at = word.find_first_not_of("+-");
    if (at == std::string_view::npos) return false;
    const char c = word[at];
    const std::string_view head = word.substr(at, 3);
    return (c == 'n' || c == 'N' || c == 'i' || c == 'I') && head.size() == 3 &&
           (head == "nan" || head == "NaN" || head == "NAN" || head == "inf" || head == "Inf" ||
            head == "INF");
}

/// The number of bytes of the character that a text begins with, in UTF-8; 0 if it is not
/// printable: a control character, one that changes the direction of what follows, or not UTF-8.
std::size_t printable_length(std::string_view text) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    if (byte(0) < 0x80) return text[0] >= ' ' && text[0] <= '~' ? 1 : 0;
    const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return 0;
    std::uint32_t code = byte(0) & (0x7FU >> length);
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(k) & 0xC0U) != 0x80U) return 0;
        code = code << 6U | (byte(k) & 0x3FU);
    }
    constexpr std::uint32_t kLeast[] = {0xA0, 0x800, 0x10000};
    const bool turns = (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
                       (code >= 0x2066 && code <= 0x2069);
    const bool is_character =
        code >= kLeast[length - 2] && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
    return is_character && !turns ? length : 0;
}

[[noreturn]] void refuse_number(std::string_view word, std::errc fault) {
    std::string complaint = in_quotes(word);
    if (fault == std::errc::result_out_of_range) {
        complaint += " is beyond the range of its type; scale the input";
    } else if (spells_no_finite_number(word)) {
        complaint += " is not a finite number; give finite numbers";
    } else if (word.find(',') != std::string_view::npos) {
        complaint += " is not a number; use a decimal point, and blanks between numbers";
    } else {
        complaint += " is not a number; write a decimal such as -1.5e3";
    }
    throw InvalidInput(complaint);
}

std::from_chars_result read(const char* begin, const char* end, double& value) {
    return read_decimal(begin, end, value);
}

std::from_chars_result read(const char* begin, const char* end, int& value) {
    return std::from_chars(begin, end, value);
}

template <class Number>
Number parse(std::string_view word) {
    checkpoint();
    const std::string_view digits = without_plus(word);
    const char* end = digits.data() + digits.size();
    const std::size_t first = !digits.empty() && digits[0] == '-' ? 1 : 0;
    const bool begins_well =
        first < digits.size() && (is_digit(digits[first]) || digits[first] == '.');
    Number value = 0;
    const auto [stop, fault] = read(digits.data(), end, value);
    if (!begins_well || stop != end) refuse_number(word, std::errc::invalid_argument);
    if (fault != std::errc()) refuse_number(word, fault);
    return value;
}

/// Appends the shortest decimal number that reads back as `value` in its precision.
template <class Number>
void append_finite(std::string& text, Number value) {
    checkpoint();
    if (!std::isfinite(value)) throw InternalError("a number to be written is not finite");
    std::array<char, 32> digits;
    const Number written = value == 0 ? Number(0) : value;
    char* const end = write_decimal(digits.data(), digits.data() + digits.size(), written);
    text.append(digits.data(), end);
}

}  // namespace

void append_number(std::string& text, double value) { append_finite(text, value); }

void append_number(std::string& text, float value) { append_finite(text, value); }

void append_number(std::string& text, int value) {
    checkpoint();
    std::array<char, 16> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(digits.data(), end);
}

double parse_number(std::string_view word) { return parse<double>(word); }

int parse_integer(std::string_view word) {
    try {
        return parse<int>(word);
    } catch (const InvalidInput&) {
        if (word.find_first_of(".eE") == std::string_view::npos) throw;
    }
    parse_number(word);
    throw InvalidInput(in_quotes(word) + " is not a whole number; write one such as 12");
}

std::string in_quotes(std::string_view word) {
    std::string text = "'";
    std::size_t n = 0;
    for (; n < kMostQuoted && !word.empty(); ++n) {
        const std::size_t length = printable_length(word);
        text += length == 0 ? "?" : word.substr(0, length);
        word.remove_prefix(std::max<std::size_t>(length, 1));
    }
    if (!word.empty()) text += "...";
    return text + "'";
}

LineScanner::LineScanner(std::string name, std::string_view text)
    : name_(std::move(name)), rest_(text) {
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool LineScanner::next() {
    checkpoint();
    words_.clear();
    if (rest_.empty()) return false;
    ++line_;
    while (true) {
        rest_.remove_prefix(kBlanks.skip_in(rest_));
        if (rest_.empty() || kLineEnds.holds(rest_.front())) break;
        const std::size_t length = kWordEnds.find_in(rest_);
        words_.push_back(rest_.substr(0, length));
        rest_.remove_prefix(length);
    }
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : rest_.empty() ? 0 : 1);
    return true;
}

std::vector<std::string_view> LineScanner::words_before_comment() const {
    std::vector<std::string_view> words;
    for (const std::string_view word : words_) {
        const std::size_t comment = word.find('#');
        if (comment != 0) words.push_back(word.substr(0, comment));
        if (comment != std::string_view::npos) break;
    }
    return words;
}

double LineScanner::number(std::string_view word) const {
    try {
        return parse_number(word);
    } catch (const InvalidInput& fault) {
        throw_bad_file(fault.what());
    }
}

int LineScanner::integer(std::string_view word) const {
    try {
        return parse_integer(word);
    } catch (const InvalidInput& fault) {
        throw_bad_file(fault.what());
    }
}

void LineScanner::throw_bad_file(const std::string& complaint) const {
    throw BadFile(name_ + ":" + std::to_string(line_) + ": " + complaint);
}

std::vector<std::string_view> words_before_comment(const LineScanner& scanner) {
    std::vector<std::string_view> words;
    for (const std::string_view word : scanner.words()) {
        const std::size_t comment = word.find('#');
        if (comment != 0) words.push_back(word.substr(0, comment));
        if (comment != std::string_view::npos) break;
    }
    return words;
}

void refuse_binary(const std::string& name, std::string_view text, const std::string& remedy) {
    for (const std::string_view mark : kUtf16Marks) {
        if (!text.starts_with(mark)) continue;
        throw BadFile(name + ":1: the text is UTF-16; save it as UTF-8");
    }
    const std::size_t place = text.find('\0');
    if (place == std::string_view::npos) return;
    // Count the lines as LineScanner does.
    int line = 1;
    for (std::size_t k = 0; k < place; ++k) {
        if (text[k] == '\n' || (text[k] == '\r' && text[k + 1] != '\n')) ++line;
    }
    throw BadFile(name + ":" + std::to_string(line) +
                  ": holds a NUL byte, so it appears to be a binary file; " + remedy);
}

}  // namespace pcvt
