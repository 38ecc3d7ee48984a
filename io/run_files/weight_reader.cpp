#include "io/run_files/weight_reader.hpp"

#include <array>
#include <cmath>
#include <optional>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "io/run_files/size_column.hpp"

namespace pcvt {
namespace {

/// Lengths and weights whose squares are numbers.
constexpr double kLargestLength = 1e150;

/// The quantity that a column holds.
enum class WeightKind { kWeight, kRadius, kDiameter };

/// Words for a kind: the prefix of a file's name, the plural of its values, and the weights that
/// come of them.
struct WeightWords {
    WeightKind kind;
    std::string_view prefix;
    const char* plural;
    const char* description;
};
constexpr std::array<WeightWords, 3> kWeightWords{
    {{WeightKind::kWeight, "weight", "weights", "lengths squared"},
     {WeightKind::kRadius, "radius", "radii", "squared radii"},
     {WeightKind::kDiameter, "diameter", "diameters", "squared halves of diameters"}}};

const WeightWords& weight_words(WeightKind kind) {
    return kWeightWords[static_cast<std::size_t>(kind)];
}

struct WeightColumn {
    std::size_t column = 0;
    WeightKind kind = WeightKind::kWeight;
};

std::optional<WeightKind> prefix_kind(const std::string& prefix) {
    for (const WeightWords& words : kWeightWords) {
        if (words.prefix == prefix) return words.kind;
    }
    return std::nullopt;
}

/// The kind that a column's name in the header states.
std::optional<WeightKind> stated_kind(std::string_view column) {
    const std::string name = comparable_name(column);
    if (name == "weight" || name == "weights") return WeightKind::kWeight;
    const std::optional<SizeKind> size = stated_size(column);
    if (size == SizeKind::kRadius) return WeightKind::kRadius;
    if (size == SizeKind::kDiameter) return WeightKind::kDiameter;
    return std::nullopt;
}

/// The kind of a column by the prefix and the header, of which one must state it.
WeightColumn stated_column(const TableScanner& scanner, const TableName& name, std::size_t column) {
    const std::optional<WeightKind> wanted = prefix_kind(name.prefix);
    if (!scanner.has_header()) return {column, wanted.value_or(WeightKind::kWeight)};
    const std::optional<WeightKind> stated = stated_kind(scanner.header()[column].name);
    if (wanted && stated && wanted != stated) {
        scanner.refuse_header(scanner.label(column) + " holds " + weight_words(*stated).plural +
                              ", but the file is given as " + weight_words(*wanted).plural +
                              "; remove " + name.prefix + ":");
    }
    if (wanted) return {column, *wanted};
    if (stated) return {column, *stated};
    scanner.refuse_header(scanner.label(column) +
                          " could hold weights, radii or diameters; say which, such as " +
                          with_columns(name, "radius", scanner.typed(column)));
}

/// The column of weights of a header; else the only one of radii or diameters. A prefix admits
/// columns of its kind only.
std::size_t find_in_header(const TableScanner& scanner, const TableName& name) {
    const std::optional<WeightKind> wanted = prefix_kind(name.prefix);
    if (!wanted || wanted == WeightKind::kWeight) {
        if (const auto column = scanner.find("weight")) return *column;
    }
    std::optional<std::size_t> only;
    for (std::size_t k = 0; k < scanner.header().size(); ++k) {
        const std::optional<WeightKind> kind = stated_kind(scanner.header()[k].name);
        if (!kind || (wanted && kind != wanted)) continue;
        if (only) {
            scanner.refuse_header("several columns may hold the radii; name one, such as " +
                                  with_columns(name, name.prefix, scanner.typed(k)));
        }
        only = k;
    }
    if (only) return *only;
    scanner.refuse_header("none of the columns " + scanner.listed_columns() + " states " +
                          (wanted ? weight_words(*wanted).plural : "weights or radii") +
                          "; name one, such as " +
                          with_columns(name, wanted ? name.prefix : "radius",
                                       scanner.typed(scanner.n_columns() - 1)));
}

WeightColumn find_weights(TableScanner& scanner, const TableName& name) {
    if (name.columns.size() > 1) {
        scanner.refuse_header("a site has one weight, but " + std::to_string(name.columns.size()) +
                              " columns are named; name one");
    }
    if (!name.columns.empty()) {
        return stated_column(scanner, name, scanner.choose(name.columns).front());
    }
    if (scanner.n_columns() == 1) return stated_column(scanner, name, 0);
    if (!scanner.has_header()) {
        scanner.refuse_header("the table has several columns; name that of the weights, such as " +
                              with_columns(name, name.prefix, std::to_string(scanner.n_columns())));
    }
    return stated_column(scanner, name, find_in_header(scanner, name));
}

double weight_of_length(TableScanner& scanner, const WeightColumn& found) {
    const double number = scanner.number(found.column);
    const std::string_view field = scanner.fields()[found.column];
    if (!(std::abs(number) < kLargestLength)) {
        scanner.refuse(found.column, in_quotes(field) + " is too large; give a number below 1e150");
    }
    if (found.kind == WeightKind::kWeight) return number;
    if (number < 0) {
        scanner.refuse(found.column, in_quotes(field) + " is negative; give a length from 0 on");
    }
    const double radius = found.kind == WeightKind::kDiameter ? number / 2 : number;
    return radius * radius;
}

}  // namespace

TableName weight_table(const std::string& text) {
    return parse_table_name(text, {"weight", "radius", "diameter"});
}

WeightFile parse_weights(const TableName& name, std::string_view text) {
    refuse_binary(name.path, text, "give a text with one weight a line");
    WeightFile file{.name = name.path};
    TableScanner scanner(name.path, text);
    std::vector<double> weights;
    if (scanner.n_columns() > 0) {
        const WeightColumn found = find_weights(scanner, name);
        if (scanner.has_header()) file.header_line = scanner.line();
        while (scanner.next()) {
            // Without a header and a named column the scanner admits rows of other widths.
            if (const std::size_t n = scanner.fields().size();
                name.columns.empty() && !scanner.has_header() && n > 1) {
                scanner.refuse("this line has " + std::to_string(n) +
                               " words; write one weight a line");
            }
            weights.push_back(weight_of_length(scanner, found));
            file.lines.push_back(scanner.line());
        }
        if (scanner.has_header() && found.kind != WeightKind::kWeight) {
            file.unit = scanner.header()[found.column].unit;
        }
        file.description =
            weight_words(found.kind).description + place_in_words(scanner, name, found.column);
    }
    if (weights.empty()) {
        throw BadFile(name.path + ": holds no weight; give one a line, one for each site");
    }
    file.weights = Eigen::Map<const Eigen::VectorXd>(weights.data(), std::ssize(weights));
    return file;
}

WeightFile read_weights(const TableName& name) {
    return parse_weights(name, read_whole_file(name.path, kSiteInput));
}

void require_weights(const WeightFile& file, int n_sites) {
    require_one_row_a_site(file.name, file.lines, n_sites, "weight");
}

}  // namespace pcvt
