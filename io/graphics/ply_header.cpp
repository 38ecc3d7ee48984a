#include "io/graphics/ply_header.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

using Words = std::vector<std::string_view>;

struct IntegerType {
    std::string_view name;
    PlyRange range;
};

constexpr PlyRange kInt8{-128, 127};
constexpr PlyRange kUint8{0, 255};
constexpr PlyRange kInt16{-32768, 32767};
constexpr PlyRange kUint16{0, 65535};
constexpr PlyRange kInt32{-2147483648, 2147483647};
constexpr PlyRange kUint32{0, 4294967295};
constexpr std::array<IntegerType, 12> kIntegerTypes{{{"char", kInt8},
                                                     {"int8", kInt8},
                                                     {"uchar", kUint8},
                                                     {"uint8", kUint8},
                                                     {"short", kInt16},
                                                     {"int16", kInt16},
                                                     {"ushort", kUint16},
                                                     {"uint16", kUint16},
                                                     {"int", kInt32},
                                                     {"int32", kInt32},
                                                     {"uint", kUint32},
                                                     {"uint32", kUint32}}};
constexpr std::array<std::string_view, 2> kSingleTypes{"float", "float32"};
constexpr std::array<std::string_view, 2> kDoubleTypes{"double", "float64"};

template <class List>
bool contains(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

/// Returns the range of an integer type; nullptr of another type.
const PlyRange* range_of(std::string_view type) {
    const auto found = std::find_if(kIntegerTypes.begin(), kIntegerTypes.end(),
                                    [&](const IntegerType& row) { return row.name == type; });
    return found == kIntegerTypes.end() ? nullptr : &found->range;
}

void check_format(const LineScanner& scanner) {
    const Words& words = scanner.words();
    if (words.size() == 3 && words[1].starts_with("binary")) {
        scanner.throw_bad_file("this PLY is binary; export it as ASCII");
    }
    if (words != Words{"format", "ascii", "1.0"}) {
        scanner.throw_bad_file("the format is not known; write \"format ascii 1.0\"");
    }
}

void read_comment(const LineScanner& scanner, const NoteTaker& take_comment) {
    const std::span<const std::string_view> words = scanner.words();
    if (words.size() < 3 || words[1] != "pcvt") return;
    // A PLY does not state sites in comments, except their phases.
    const bool names_sites = words[2].starts_with("site") && words[2] != "site_phases";
    if (!names_sites && take_comment(scanner, words[2], words.subspan(3))) return;
    scanner.throw_bad_file("pcvt does not know " + in_quotes(words[2]) + "; remove the line");
}

void read_element(const LineScanner& scanner, std::vector<PlyElement>& elements) {
    const Words& words = scanner.words();
    if (words.size() != 3) scanner.throw_bad_file("an element has a name and a count; write both");
    const int count = scanner.integer(words[2]);
    if (count < 0) scanner.throw_bad_file("a count is negative; correct it");
    for (const PlyElement& element : elements) {
        if (element.name == words[1]) {
            scanner.throw_bad_file("element " + in_quotes(words[1]) +
                                   " is declared twice; remove one");
        }
    }
    elements.push_back({words[1], count, {}});
}

void read_property(const LineScanner& scanner, std::vector<PlyElement>& elements) {
    // `property TYPE NAME` or `property list COUNT_TYPE TYPE NAME`.
    const Words& words = scanner.words();
    const PlyRange* lengths =
        words.size() == 5 && words[1] == "list" ? range_of(words[2]) : nullptr;
    const bool is_list = lengths != nullptr;
    if (!is_list && words.size() != 3) {
        scanner.throw_bad_file("a property has a type and a name; write \"property double x\"");
    }
    if (elements.empty()) scanner.throw_bad_file("a property precedes every element; remove it");
    // Type and name are the last two words of both forms.
    const std::string_view type = words[words.size() - 2];
    const bool is_single = contains(kSingleTypes, type);
    const bool is_real = is_single || contains(kDoubleTypes, type);
    const PlyRange* values = range_of(type);
    std::string declared(words[1]);
    for (std::size_t w = 2; w + 1 < words.size(); ++w) declared += ' ' + std::string(words[w]);
    if (!is_real && values == nullptr) {
        scanner.throw_bad_file("the type " + in_quotes(type) +
                               " is not known; write int or double");
    }
    if (elements.back().find(words.back())) {
        scanner.throw_bad_file("property " + in_quotes(words.back()) +
                               " is declared twice; remove one");
    }
    elements.back().properties.push_back({.name = words.back(),
                                          .is_real = is_real,
                                          .is_single = is_single,
                                          .is_list = is_list,
                                          .values = values ? *values : PlyRange{},
                                          .lengths = lengths ? *lengths : PlyRange{},
                                          .type = declared});
}

}  // namespace

const PlyProperty* PlyElement::find(std::string_view property) const {
    const auto found = std::find_if(properties.begin(), properties.end(),
                                    [&](const PlyProperty& p) { return p.name == property; });
    return found == properties.end() ? nullptr : &*found;
}

std::vector<PlyElement> read_ply_header(LineScanner& scanner, const std::string& name,
                                        const NoteTaker& take_comment) {
    // The first line is "ply".
    if (!scanner.next() || scanner.words() != Words{"ply"}) {
        throw BadFile(name + ": does not begin with the line \"ply\"; give a PLY file");
    }
    // One declaration per line follows, up to end_header.
    bool has_format = false;
    std::vector<PlyElement> elements;
    while (scanner.next()) {
        const std::string_view key = scanner.words().empty() ? "" : scanner.words().front();
        if (key == "end_header") {
            if (!has_format)
                scanner.throw_bad_file("the format is missing; write \"format ascii 1.0\"");
            return elements;
        }
        if (key == "comment") {
            read_comment(scanner, take_comment);
        } else if (key == "element") {
            read_element(scanner, elements);
        } else if (key == "property") {
            read_property(scanner, elements);
        } else if (key == "format") {
            check_format(scanner);
            has_format = true;
        } else if (!key.empty() && key != "obj_info") {
            scanner.throw_bad_file(in_quotes(key) + " is not a header keyword; remove the line");
        }
    }
    throw BadFile(name + ": the header does not end; write \"end_header\" after it");
}

void PlyValues::read(const LineScanner& scanner, const PlyElement& element) {
    // Words are taken one by one.
    std::size_t at = 0;
    const auto next_word = [&] {
        if (at == scanner.words().size()) {
            scanner.throw_bad_file("the line is too short; correct it or the header");
        }
        return scanner.words()[at++];
    };
    const auto next_integer = [&](const PlyRange& range) {
        const int number = scanner.integer(next_word());
        if (number < range.least || number > range.most) {
            scanner.throw_bad_file(std::to_string(number) +
                                   " is beyond its declared type; correct it or the header");
        }
        return number;
    };
    // A list begins with its length.
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        const int count = property.is_list ? next_integer(property.lengths) : 1;
        std::vector<double>& numbers = of_[p].second;
        numbers.clear();
        for (int k = 0; k < count; ++k) {
            numbers.push_back(property.is_real ? scanner.number(next_word())
                                               : next_integer(property.values));
        }
    }
    if (at != scanner.words().size()) {
        scanner.throw_bad_file("the line is too long; correct it or the header");
    }
}

const std::vector<double>& PlyValues::list(std::string_view name) const {
    static const std::vector<double> none;
    for (const auto& [key, values] : of_) {
        if (key == name) return values;
    }
    return none;
}

void read_ply_rows(LineScanner& scanner, const PlyElement& element,
                   const std::function<void(const PlyValues&)>& take) {
    PlyValues values(element);
    for (int k = 0; k < element.count; ++k) {
        checkpoint_each(k);
        do {
            if (!scanner.next()) {
                scanner.throw_bad_file("the file ends before its last " + in_quotes(element.name) +
                                       "; correct the counts or give the whole file");
            }
        } while (scanner.words().empty());
        values.read(scanner, element);
        take(values);
    }
}

void require_ply_end(LineScanner& scanner) {
    while (scanner.next()) {
        if (scanner.words().empty()) continue;
        scanner.throw_bad_file("the file has data after its last element; correct the counts");
    }
}

}  // namespace pcvt
