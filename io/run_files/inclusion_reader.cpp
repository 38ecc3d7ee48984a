#include "io/run_files/inclusion_reader.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "mesher/base/comma_list.hpp"
#include "mesher/base/error.hpp"
#include "mesher/cells/phase_fractions.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

using Numbers = std::span<const double>;

plane::Shape circle(Numbers x) { return plane::Circle{{x[0], x[1]}, x[2]}; }

plane::Shape ellipse(Numbers x) { return plane::Ellipse{{x[0], x[1]}, x[2], x[3], x[4]}; }

plane::Shape polygon(Numbers x) {
    plane::Polygon corners;
    for (std::size_t k = 0; k + 1 < x.size(); k += 2) corners.emplace_back(x[k], x[k + 1]);
    return corners;
}

/// One kind of shape in a file.
struct ShapeRow {
    const char* word;
    const char* article;
    /// The numbers that follow the tag, for messages.
    const char* form;
    std::size_t fewest;
    /// With more than `fewest`, there may be any number of pairs.
    bool takes_more_pairs;
    plane::Shape (*make)(Numbers);
};

constexpr std::array kShapes{
    ShapeRow{"circle", "a ", "x y r", 3, false, circle},
    ShapeRow{"ellipse", "an ", "x y a b degrees", 5, false, ellipse},
    ShapeRow{"polygon", "a ", "x1 y1 x2 y2 x3 y3 ...", 6, true, polygon},
};

constexpr const char* kForms =
    "write \"circle TAG x y r\", \"ellipse TAG x y a b degrees\" or \"polygon TAG x1 y1 x2 y2 x3 "
    "y3 ...\"";

const ShapeRow& shape_row(const LineScanner& scanner, std::string_view word) {
    for (const ShapeRow& row : kShapes) {
        if (row.word == word) return row;
    }
    scanner.throw_bad_file(in_quotes(word) + " is not a shape; " + kForms);
}

/// The number of a tag, which counts from 1 and is added to `tags` if it is new.
int tag_number(const LineScanner& scanner, std::string_view word, std::vector<std::string>& tags) {
    const auto known = std::find(tags.begin(), tags.end(), word);
    const auto number = static_cast<int>(known - tags.begin()) + 1;
    if (known != tags.end()) return number;
    try {
        require_phase_names({kMatrixTag, std::string(word)});
    } catch (const InvalidInput& fault) {
        scanner.throw_bad_file("the tag " + in_quotes(word) + ": " + fault.what());
    }
    tags.emplace_back(word);
    return number;
}

/// Requires that the tags differ by more than their case, and are not too many.
void require_distinct_tags(const std::string& name, const std::vector<std::string>& tags) {
    try {
        require_phase_names(tags);
    } catch (const InvalidInput& fault) {
        throw BadFile(name + ": " + fault.what());
    }
}

plane::Shape parse_shape(const LineScanner& scanner, const ShapeRow& row,
                         std::span<const std::string_view> words) {
    const bool fits = row.takes_more_pairs
                          ? words.size() >= row.fewest && words.size() % 2 == row.fewest % 2
                          : words.size() == row.fewest;
    if (!fits) {
        scanner.throw_bad_file(std::string(row.article) + row.word + " does not take " +
                               std::to_string(words.size()) + " numbers; write \"" + row.word +
                               " TAG " + row.form + "\"");
    }
    std::vector<double> numbers;
    for (const std::string_view word : words) numbers.push_back(scanner.number(word));
    return row.make(numbers);
}

}  // namespace

InclusionFile parse_inclusions(const std::string& name, std::string_view text) {
    refuse_binary(name, text, "give a text with one inclusion a line");
    LineScanner scanner(name, text);
    InclusionFile file{.name = name, .inclusions = {}, .tags = {}};
    while (scanner.next()) {
        const std::vector<std::string_view> words = scanner.words_before_comment();
        if (words.empty()) continue;
        const ShapeRow& row = shape_row(scanner, words[0]);
        if (words.size() < 2) scanner.throw_bad_file(std::string("a tag is missing; ") + kForms);
        const int tag = tag_number(scanner, words[1], file.tags);
        plane::Shape shape = parse_shape(scanner, row, std::span(words).subspan(2));
        file.inclusions.push_back({.shape = std::move(shape), .tag = tag, .line = scanner.line()});
    }
    if (file.inclusions.empty()) throw BadFile(name + ": holds no inclusion; " + kForms);
    require_distinct_tags(name, file.tags);
    return file;
}

void require_tag_names(const InclusionFile& file) {
    std::vector<std::string> names = file.tags;
    names.emplace_back(kMatrixTag);
    for (const plane::Inclusion& inclusion : file.inclusions) {
        const std::string where = file.name + ":" + std::to_string(inclusion.line) + ": the tag";
        require_free_name(where, file.tags[inclusion.tag - 1], names);
    }
}

plane::RandomCircles parse_fibres(std::string_view text) {
    const std::vector<std::string_view> words = between_commas(text);
    if (words.size() != 2 && words.size() != 3) {
        throw InvalidInput(in_quotes(text) +
                           " does not describe fibres; write FRACTION,N or FRACTION,N,GAP, "
                           "such as 0.5,30");
    }
    plane::RandomCircles fibres{.fraction = parse_number(words[0]), .n = parse_integer(words[1])};
    if (words.size() == 3) fibres.gap = parse_number(words[2]);
    return fibres;
}

std::vector<std::string> parse_tags(std::string_view text) {
    const std::vector<std::string_view> words = between_commas(text);
    return {words.begin(), words.end()};
}

InclusionFile read_inclusions(const std::string& path) {
    return parse_inclusions(path, read_whole_file(path, kSiteInput));
}

}  // namespace pcvt
