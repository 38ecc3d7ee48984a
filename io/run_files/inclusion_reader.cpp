#include "io/run_files/inclusion_reader.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "io/run_files/table_reader.hpp"
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

const ShapeRow* find_shape(std::string_view word) {
    const std::string name = comparable_name(word);
    const auto* const row = std::find_if(kShapes.begin(), kShapes.end(),
                                         [&](const ShapeRow& shape) { return shape.word == name; });
    return row == kShapes.end() ? nullptr : row;
}

bool ends_word(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\v' || c == '\f'; }

/// Splits a line at blanks and commas; two commas in a row have an empty word between them.
void split_at_both(std::string_view content, std::vector<std::string_view>& words) {
    words.clear();
    bool follows_comma = false;
    while (!content.empty()) {
        if (content.front() == ',') {
            if (follows_comma) words.emplace_back();
            follows_comma = true;
            content.remove_prefix(1);
        } else if (ends_word(content.front())) {
            content.remove_prefix(1);
        } else {
            const std::size_t end = static_cast<std::size_t>(
                std::find_if(content.begin(), content.end(), ends_word) - content.begin());
            words.push_back(without_quotes(content.substr(0, end)));
            follows_comma = false;
            content.remove_prefix(end);
        }
    }
}

bool takes(const ShapeRow& row, std::size_t n_numbers) {
    return row.takes_more_pairs ? n_numbers >= row.fewest && n_numbers % 2 == row.fewest % 2
                                : n_numbers == row.fewest;
}

/// The rows of a file of shapes: blanks, commas, or both separate their words; else semicolons or
/// tabs, between which numbers may have decimal commas.
class ShapeScanner {
   public:
    ShapeScanner(const std::string& name, std::string_view text) : table_(name, text, false) {}

    bool next() {
        if (!table_.next()) return false;
        if (has_fields()) {
            words_ = table_.fields();
            while (words_.size() > 1 && words_.back().empty()) words_.pop_back();
        } else {
            split_at_both(table_.content(), words_);
        }
        return true;
    }

    int line() const { return table_.line(); }
    const std::vector<std::string_view>& words() const { return words_; }
    [[noreturn]] void refuse(const std::string& complaint) const { table_.refuse(complaint); }

    /// The numbers behind the tag, which fit the shape.
    std::vector<double> numbers(const ShapeRow& row) {
        constexpr std::size_t kFirst = 2;
        if (!has_fields()) refuse_decimal_commas(row);
        if (!takes(row, words_.size() - kFirst)) {
            refuse(std::string(row.article) + row.word + " does not take " +
                   std::to_string(words_.size() - kFirst) + " numbers; write \"" + row.word +
                   " TAG " + row.form + "\"");
        }
        std::vector<double> numbers;
        for (std::size_t k = kFirst; k < words_.size(); ++k) {
            numbers.push_back(has_fields() ? table_.number(k) : number(words_[k]));
        }
        return numbers;
    }

   private:
    bool has_fields() const {
        return table_.separator() == Separator::kSemicolon || table_.separator() == Separator::kTab;
    }

    double number(std::string_view word) const {
        if (word.empty()) refuse("a field is empty; give a number");
        try {
            return parse_number(word);
        } catch (const InvalidInput& fault) {
            refuse(fault.what());
        }
    }

    /// Refuses "circle TAG 0,5 0,5 0,2", whose numbers fit the shape if the commas are decimal
    /// marks.
    void refuse_decimal_commas(const ShapeRow& row) const {
        if (separator_of(table_.content()) != Separator::kBlanks) return;
        std::vector<std::string_view> words;
        split_fields(table_.content(), Separator::kBlanks, words);
        std::string_view first;
        for (const std::string_view word : words) {
            const auto n_commas = std::count(word.begin(), word.end(), ',');
            if (n_commas > 1 || (n_commas == 1 && word.find('.') != std::string_view::npos)) return;
            if (n_commas == 1 && first.empty()) first = word;
        }
        if (first.empty() || words.size() < 2 || !takes(row, words.size() - 2)) return;
        refuse(in_quotes(first) +
               " may be one number or two; write decimal points, or semicolons between fields");
    }

    TableScanner table_;
    std::vector<std::string_view> words_;
};

/// The text without the header of a table, which names columns in place of a shape.
std::string without_header(const std::string& name, std::string_view text) {
    std::string rows(text);
    TableLines lines(name, text);
    if (!lines.next()) return rows;
    std::vector<std::string_view> fields;
    split_fields(lines.content(), separator_of(lines.content()), fields);
    std::vector<std::string_view> words;
    split_at_both(fields.front(), words);
    const bool has_shape = !words.empty() && find_shape(words.front()) != nullptr;
    if (fields.size() < 2 || has_shape || !is_header(fields)) return rows;
    rows[static_cast<std::size_t>(lines.content().data() - text.data())] = '#';
    return rows;
}

const ShapeRow& shape_row(const ShapeScanner& scanner, std::string_view word) {
    const ShapeRow* const row = find_shape(word);
    if (row == nullptr) scanner.refuse(in_quotes(word) + " is not a shape; " + kForms);
    return *row;
}

/// The number of a tag, which counts from 1 and is added to `tags` if it is new.
int tag_number(const ShapeScanner& scanner, std::string_view word, std::vector<std::string>& tags) {
    const auto known = std::find(tags.begin(), tags.end(), word);
    const auto number = static_cast<int>(known - tags.begin()) + 1;
    if (known != tags.end()) return number;
    try {
        require_phase_names({kMatrixTag, std::string(word)});
    } catch (const InvalidInput& fault) {
        scanner.refuse("the tag " + in_quotes(word) + ": " + fault.what());
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

}  // namespace

InclusionFile parse_inclusions(const std::string& name, std::string_view text) {
    refuse_binary(name, text, "give a text with one inclusion a line");
    const std::string rows = without_header(name, text);
    ShapeScanner scanner(name, rows);
    InclusionFile file{.name = name, .inclusions = {}, .tags = {}};
    while (scanner.next()) {
        const std::vector<std::string_view>& words = scanner.words();
        const ShapeRow& row = shape_row(scanner, words.empty() ? "" : words[0]);
        if (words.size() < 2) scanner.refuse(std::string("a tag is missing; ") + kForms);
        const int tag = tag_number(scanner, words[1], file.tags);
        plane::Shape shape = row.make(scanner.numbers(row));
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
