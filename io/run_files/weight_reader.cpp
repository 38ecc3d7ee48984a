#include "io/run_files/weight_reader.hpp"

#include <cmath>
#include <optional>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "io/run_files/size_column.hpp"

namespace pcvt {
namespace {

/// Lengths and weights whose squares are numbers.
constexpr double kLargestLength = 1e150;

/// A column, and the lengths that it holds in place of weights.
struct WeightColumn {
    std::size_t column = 0;
    std::optional<SizeKind> lengths = {};
};

bool is_weight(std::string_view column) {
    const std::string name = comparable_name(column);
    return name == "weight" || name == "weights";
}

/// The kind that the name of a column states; refuses a name that states neither.
WeightColumn stated_column(TableScanner& scanner, const TableName& name, std::size_t column) {
    if (name.prefix == "weight") return {column};
    if (name.prefix == "radius") return {column, SizeKind::kRadius};
    if (name.prefix == "diameter") return {column, SizeKind::kDiameter};
    if (!scanner.has_header() || is_weight(scanner.header()[column].name)) return {column};
    const std::optional<SizeKind> size = stated_size(scanner.header()[column].name);
    if (size == SizeKind::kRadius || size == SizeKind::kDiameter) return {column, size};
    scanner.refuse_header(scanner.label(column) +
                          " could hold weights, radii or diameters; say which, such as " +
                          with_columns(name, "radius", scanner.header()[column].name));
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
                              with_columns(name, name.prefix, "3"));
    }
    if (const auto column = scanner.find("weight")) return stated_column(scanner, name, *column);
    std::optional<std::size_t> only;
    for (std::size_t k = 0; k < scanner.header().size(); ++k) {
        const std::optional<SizeKind> size = stated_size(scanner.header()[k].name);
        if (size != SizeKind::kRadius && size != SizeKind::kDiameter) continue;
        if (only) {
            scanner.refuse_header("several columns may hold the radii; name one, such as " +
                                  with_columns(name, name.prefix, scanner.header()[k].name));
        }
        only = k;
    }
    if (only) return stated_column(scanner, name, *only);
    scanner.refuse_header("none of the columns " + scanner.listed_columns() +
                          " states weights or radii; name one, such as " +
                          with_columns(name, "radius", scanner.header().back().name));
}

double weight_of_length(TableScanner& scanner, const WeightColumn& found) {
    const double number = scanner.number(found.column);
    const std::string_view field = scanner.fields()[found.column];
    if (!(std::abs(number) < kLargestLength)) {
        scanner.refuse(found.column, in_quotes(field) + " is too large; give a number below 1e150");
    }
    if (!found.lengths) return number;
    if (number < 0) {
        scanner.refuse(found.column, in_quotes(field) + " is negative; give a length from 0 on");
    }
    const double radius = *found.lengths == SizeKind::kDiameter ? number / 2 : number;
    return radius * radius;
}

std::string weight_description(const TableScanner& scanner, const TableName& name,
                               const WeightColumn& found) {
    std::string text = !found.lengths                        ? "lengths squared"
                       : *found.lengths == SizeKind::kRadius ? "squared radii"
                                                             : "squared halves of diameters";
    if (scanner.has_header()) {
        const TableColumn& column = scanner.header()[found.column];
        const std::string quoted = in_quotes(column.name);
        text += " of column " + quoted.substr(1, quoted.size() - 2) +
                (column.unit.empty() ? "" : " (" + column.unit + ")");
    }
    return text + " of " + name.path;
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
        while (scanner.next()) {
            weights.push_back(weight_of_length(scanner, found));
            file.lines.push_back(scanner.line());
        }
        file.description = weight_description(scanner, name, found);
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
    const auto n = static_cast<int>(file.weights.size());
    if (n == n_sites) return;
    const int line = n < n_sites ? file.lines.back() : file.lines[std::size_t(n_sites)];
    throw BadFile(file.name + ":" + std::to_string(line) + ": " +
                  (n < n_sites ? "the last of " + std::to_string(n) + " weights"
                               : "weight " + std::to_string(n_sites + 1)) +
                  ", but there are " + std::to_string(n_sites) +
                  " sites; give one weight for each site");
}

}  // namespace pcvt
