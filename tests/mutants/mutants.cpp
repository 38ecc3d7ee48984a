#include "tests/mutants/mutants.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

namespace pcvt::testing {
namespace {

template <class Number>
std::optional<Number> parsed(const std::string& text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, number);
    return fault == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

std::string words_of(double number) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number);
    return {text.data(), end.ptr};
}

struct NewValue {
    const char* change;
    std::string value;
};

std::vector<NewValue> new_values(const std::string& value, double digit) {
    if (const auto n = parsed<long long>(value)) {
        std::vector<NewValue> values{{"+1", std::to_string(*n + 1)},
                                     {"-1", std::to_string(*n - 1)}};
        if (*n != 0 && *n != 1) values.push_back({"sign", std::to_string(-*n)});
        return values;
    }
    if (const auto x = parsed<double>(value)) {
        std::vector<NewValue> values{
            {"+1", words_of(*x + 1)}, {"-1", words_of(*x - 1)}, {"digit", words_of(*x + digit)}};
        if (*x != 0) values.push_back({"sign", words_of(-*x)});
        return values;
    }
    return {{"word", value + "x"}};
}

std::vector<std::string_view> split(std::string_view line, std::string_view separators) {
    const std::string blanks = " \t\r" + std::string(separators);
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t begin = line.find_first_not_of(blanks, at);
        if (begin == std::string_view::npos) break;
        const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        at = end;
    }
    return words;
}

Files replaced(const Files& files, std::size_t file, std::size_t at, std::size_t length,
               const std::string& value) {
    std::string bytes = files[file].bytes;
    return with_bytes(files, file, bytes.replace(at, length, value));
}

/// A line with its line feed.
struct Row {
    std::size_t begin;
    std::string text;
    /// The words of a part of a list, each behind a blank; empty: the row is another one.
    std::string part = {};
};

/// Whether two rows say the same in both orders.
bool commute(const Row& row, const Row& next) {
    return row.text == next.text ||
           (!row.part.empty() && row.part + next.part == next.part + row.part);
}

void add_row_mutants(const Files& files, std::size_t file, const std::string& name,
                     const std::vector<Row>& rows, std::vector<Mutant>& mutants) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Row& row = rows[k];
        const auto change = [&](const char* how, std::size_t length, const std::string& text) {
            mutants.push_back({name, how, [&files, file, at = row.begin, length, text] {
                                   return replaced(files, file, at, length, text);
                               }});
        };
        change("delete", row.text.size(), "");
        change("duplicate", 0, row.text);
        const bool adjacent = k + 1 < rows.size() && !commute(row, rows[k + 1]) &&
                              rows[k + 1].begin == row.begin + row.text.size();
        if (!adjacent) continue;
        change("swap", row.text.size() + rows[k + 1].text.size(), rows[k + 1].text + row.text);
    }
}

std::string part_of(const std::vector<std::string_view>& words, const LineNames& names) {
    std::string part;
    if (names.n_before_part == 0) return part;
    for (std::size_t w = names.n_before_part; w < words.size(); ++w) {
        part += ' ';
        part += words[w];
    }
    return part;
}

std::string encoded(const std::string& value, Binary type) {
    const auto bytes_of = [](auto number) {
        return std::string(reinterpret_cast<const char*>(&number), sizeof number);
    };
    const double number = parsed<double>(value).value_or(0);
    switch (type) {
        case Binary::kUint8:
            return bytes_of(static_cast<std::uint8_t>(static_cast<long long>(number)));
        case Binary::kUint16:
            return bytes_of(static_cast<std::uint16_t>(static_cast<long long>(number)));
        case Binary::kInt32:
            return bytes_of(static_cast<std::int32_t>(static_cast<long long>(number)));
        case Binary::kUint32:
            return bytes_of(static_cast<std::uint32_t>(static_cast<long long>(number)));
        case Binary::kFloat32:
            return bytes_of(static_cast<float>(number));
        case Binary::kFloat64:
            return bytes_of(number);
    }
    return {};
}

std::string decoded(const char* data, Binary type) {
    const auto number_of = [data](auto number) {
        std::memcpy(&number, data, sizeof number);
        return number;
    };
    // Real numbers keep a point, so that they change as real numbers.
    const auto real = [](double number) {
        const std::string text = words_of(number);
        const bool whole = text.find_first_not_of("-0123456789") == std::string::npos;
        return whole ? text + ".0" : text;
    };
    switch (type) {
        case Binary::kUint8:
            return std::to_string(number_of(std::uint8_t{}));
        case Binary::kUint16:
            return std::to_string(number_of(std::uint16_t{}));
        case Binary::kInt32:
            return std::to_string(number_of(std::int32_t{}));
        case Binary::kUint32:
            return std::to_string(number_of(std::uint32_t{}));
        case Binary::kFloat32:
            return real(number_of(float{}));
        case Binary::kFloat64:
            return real(number_of(double{}));
    }
    return {};
}

}  // namespace

Files with_bytes(const Files& files, std::size_t file, std::string bytes) {
    Files changed = files;
    changed[file].bytes = std::move(bytes);
    return changed;
}

std::vector<Mutant> mutants_of(const std::vector<Field>& fields, double digit) {
    std::vector<Mutant> mutants;
    // The first different value after a field, of the same name.
    std::map<std::string, std::vector<const Field*>> by_name;
    for (const Field& field : fields) by_name[field.name].push_back(&field);
    std::map<std::string, std::size_t> seen;
    for (const Field& field : fields) {
        for (const auto& [change, value] : new_values(field.value, digit)) {
            mutants.push_back(
                {field.name, change, [with = field.with, other = value] { return with(other); }});
        }
        const std::vector<const Field*>& family = by_name[field.name];
        for (std::size_t k = ++seen[field.name]; k < family.size(); ++k) {
            if (family[k]->value == field.value) continue;
            mutants.push_back(
                {field.name, "exchange",
                 [with = field.with, value = family[k]->value] { return with(value); }});
            break;
        }
    }
    return mutants;
}

TextParts text_parts(const Files& files, std::size_t file, const LineNamer& namer,
                     std::string_view separators) {
    TextParts parts;
    std::map<std::string, std::vector<Row>> rows;
    const std::string& text = files[file].bytes;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        const std::string_view line = std::string_view(text).substr(begin, end - begin);
        std::string_view content = line;
        if (content.ends_with('\n')) content.remove_suffix(1);
        const std::vector<std::string_view> words = split(content, separators);
        const LineNames names = namer(words);
        if (!names.row.empty()) {
            rows[names.row].push_back({begin, std::string(line), part_of(words, names)});
        }
        for (std::size_t w = 0; w < std::min(words.size(), names.words.size()); ++w) {
            if (names.words[w].empty()) continue;
            const auto at = static_cast<std::size_t>(words[w].data() - text.data());
            const auto with = [&files, file, at, n = words[w].size()](const std::string& value) {
                return replaced(files, file, at, n, value);
            };
            parts.fields.push_back({names.words[w], std::string(words[w]), with});
        }
        begin = end;
    }
    for (const auto& [name, of_name] : rows) {
        add_row_mutants(files, file, name, of_name, parts.rows);
    }
    return parts;
}

std::vector<Mutant> text_mutants(const Files& files, std::size_t file, const LineNamer& namer,
                                 std::string_view separators, double digit) {
    const TextParts parts = text_parts(files, file, namer, separators);
    std::vector<Mutant> mutants = mutants_of(parts.fields, digit);
    mutants.insert(mutants.end(), parts.rows.begin(), parts.rows.end());
    return mutants;
}

std::size_t width_of(Binary type) { return encoded("0", type).size(); }

std::vector<Field> binary_fields(const Files& files, std::size_t file, std::size_t at,
                                 std::size_t count, Binary type,
                                 const std::vector<std::string>& names) {
    std::vector<Field> fields;
    const std::size_t width = width_of(type);
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t place = at + k * width;
        fields.push_back({names[k % names.size()], decoded(files[file].bytes.data() + place, type),
                          [&files, file, place, width, type](const std::string& value) {
                              return replaced(files, file, place, width, encoded(value, type));
                          }});
    }
    return fields;
}

}  // namespace pcvt::testing
