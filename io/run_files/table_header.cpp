#include "io/run_files/table_header.hpp"

#include <algorithm>
#include <array>

#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

/// A character of UTF-8 or Latin-1, and how it is written in ASCII.
struct Spelling {
    std::string_view bytes;
    std::string_view ascii;
};
constexpr std::array<Spelling, 11> kSpellings{{{"\xC2\xB5", "u"},
                                               {"\xCE\xBC", "u"},
                                               {"\xC2\xB2", "^2"},
                                               {"\xC2\xB0", "deg"},
                                               {"\xCF\x86", "phi"},
                                               {"\xCF\x95", "phi"},
                                               {"\xCE\xA6", "phi"},
                                               {"\xE2\x82\x81", "1"},
                                               {"\xE2\x82\x82", "2"},
                                               {"\xB5", "u"},
                                               {"\xB0", "deg"}}};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// A text in ASCII; characters without a spelling become question marks.
std::string in_ascii(std::string_view text) {
    std::string ascii;
    while (!text.empty()) {
        const auto* const known = std::find_if(
            kSpellings.begin(), kSpellings.end(),
            [&](const Spelling& spelling) { return text.starts_with(spelling.bytes); });
        if (known != kSpellings.end()) {
            ascii += known->ascii;
            text.remove_prefix(known->bytes.size());
            continue;
        }
        ascii += text.front() >= ' ' && text.front() <= '~' ? text.front() : '?';
        text.remove_prefix(1);
    }
    return ascii;
}

bool spells_no_finite_number(std::string_view word) {
    constexpr std::array<std::string_view, 4> kWords{"nan", "inf", "infinity", "na"};
    std::string letters;
    for (const char c : word) letters += lower(c);
    if (letters.starts_with('-') || letters.starts_with('+')) letters.erase(0, 1);
    return std::find(kWords.begin(), kWords.end(), letters) != kWords.end();
}

/// Whether a field is meant as a number, with a decimal point or a decimal comma.
bool is_meant_as_number(std::string_view field) {
    if (spells_no_finite_number(field)) return true;
    std::string digits(field);
    std::replace(digits.begin(), digits.end(), ',', '.');
    // Fortran writes 0.5D+02.
    std::replace(digits.begin(), digits.end(), 'D', 'e');
    if (digits.starts_with('+')) digits.erase(0, 1);
    double value = 0;
    const char* const end = digits.data() + digits.size();
    return read_decimal(digits.data(), end, value).ptr == end;
}

bool holds_letter(std::string_view field) {
    return std::any_of(field.begin(), field.end(), [](char c) {
        return (lower(c) >= 'a' && lower(c) <= 'z') || static_cast<unsigned char>(c) >= 0x80;
    });
}

}  // namespace

bool is_header(std::span<const std::string_view> fields) {
    const auto is_number = [](std::string_view field) {
        return !field.empty() && is_meant_as_number(field);
    };
    return std::none_of(fields.begin(), fields.end(), is_number) &&
           std::any_of(fields.begin(), fields.end(), holds_letter);
}

TableColumn header_column(std::string_view field) {
    const char last = field.empty() ? ' ' : field.back();
    const std::size_t open = last == ')' ? field.rfind('(') : last == ']' ? field.rfind('[') : 0;
    if (open == 0 || open == std::string_view::npos) return {.name = std::string(field)};
    std::string_view name = field.substr(0, open);
    while (name.ends_with(' ') || name.ends_with('\t') || name.ends_with('_'))
        name.remove_suffix(1);
    return {.name = std::string(name),
            .unit = in_ascii(field.substr(open + 1, field.size() - open - 2))};
}

std::vector<TableColumn> header_columns(std::span<const std::string_view> fields,
                                        Separator separator) {
    std::vector<TableColumn> columns;
    for (const std::string_view field : fields) {
        const bool is_unit = field.size() > 2 && ((field.front() == '(' && field.back() == ')') ||
                                                  (field.front() == '[' && field.back() == ']'));
        if (separator == Separator::kBlanks && is_unit && !columns.empty() &&
            columns.back().unit.empty()) {
            columns.back().unit = in_ascii(field.substr(1, field.size() - 2));
            continue;
        }
        columns.push_back(header_column(field));
    }
    return columns;
}

std::string comparable_name(std::string_view name) {
    std::string letters;
    for (const char c : in_ascii(name)) {
        if (c == ' ' || c == '_' || c == '-' || c == '.') continue;
        letters += lower(c);
    }
    return letters;
}

}  // namespace pcvt
