#include "io/run_files/area_reader.hpp"

#include <algorithm>
#include <array>

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"
#include "io/run_files/size_column.hpp"
#include "mesher/cells/target_areas.hpp"

namespace pcvt {
namespace {

/// Sizes whose squares are numbers.
constexpr double kLeastSize = 1e-150;
constexpr double kLargestSize = 1e150;

double parse_size(TableScanner& scanner, std::size_t column, bool is_first) {
    const double size = scanner.number(column);
    if (size >= kLeastSize && size <= kLargestSize) return size;
    const std::string_view field = scanner.fields()[column];
    if (size == 0 && is_first && column > 0 && scanner.fields()[0] == "0") {
        scanner.refuse(column,
                       in_quotes(field) +
                           " is not the size of a cell, but exporters list a feature 0 without "
                           "a size; remove the line");
    }
    scanner.refuse(column, in_quotes(field) +
                               " is not the size of a cell; give a number from 1e-150 to 1e150");
}

/// Refuses a table without a header that has several columns, none of which is named.
void require_one_word(const TableScanner& scanner, const TableName& name, const std::string& word) {
    const std::size_t n = scanner.fields().size();
    if (n == 1) return;
    const std::string named = "name a column, such as " + with_columns(name, name.prefix, "2");
    if (n == 2 && scanner.separator() == Separator::kComma) {
        const std::string both =
            std::string(scanner.fields()[0]) + "," + std::string(scanner.fields()[1]);
        scanner.refuse(in_quotes(both) +
                       " is not a number; write a decimal point, or where the comma separates two "
                       "columns " +
                       named);
    }
    scanner.refuse("this line has " + std::to_string(n) + " words; write one " + word +
                   " a line, or " + named);
}

/// Refuses column 1 of "0,5", which is rather one number than two columns.
void refuse_decimal_commas(const TableScanner& scanner, std::size_t column) {
    const std::vector<std::string_view>& fields = scanner.fields();
    if (scanner.has_header() || column != 0 || fields.size() != 2 ||
        scanner.separator() != Separator::kComma) {
        return;
    }
    const bool are_digits = std::all_of(fields.begin(), fields.end(), [](std::string_view field) {
        return !field.empty() && field.find_first_not_of("0123456789") == std::string_view::npos;
    });
    if (!are_digits) return;
    scanner.refuse(
        "'" + std::string(fields[0]) + "," + std::string(fields[1]) +
        "' may be one number or two; write decimal points, or semicolons between columns");
}

std::string description(const TableScanner& scanner, const TableName& name,
                        const SizeColumn& sizes) {
    const bool is_plain = name.columns.empty() && name.prefix.empty() && scanner.n_columns() == 1;
    if (is_plain && (!scanner.has_header() || (scanner.header()[0].name == "diameter" &&
                                               scanner.header()[0].unit.empty()))) {
        return name.path;
    }
    return size_words(sizes.kind).plural + place_in_words(scanner, name, sizes.column);
}

/// The areas, or the volumes, of a column.
Eigen::VectorXd sizes_of(const std::vector<double>& column, SizeKind kind,
                         const SizeOption& option) {
    Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(column.data(), std::ssize(column));
    if (kind == option.plain) return values;
    if (kind == SizeKind::kRadius) values *= 2;
    return option.plain == SizeKind::kVolume ? volumes_of_diameters(values)
                                             : areas_of_diameters(values);
}

BadFile at_line(const AreaFile& file, int line, const std::string& complaint) {
    return BadFile(file.name + ":" + std::to_string(line) + ": " + complaint);
}

/// Reads a table of sizes for an option.
AreaFile parse_sizes(const TableName& name, std::string_view text, const SizeOption& option) {
    const std::string word(size_words(option.plain).prefix);
    refuse_binary(name.path, text, "give a text with one " + word + " a line");
    AreaFile file{.name = name.path};
    TableScanner scanner(name.path, text);
    std::vector<double> sizes;
    if (scanner.n_columns() > 0) {
        const SizeColumn found = find_sizes(scanner, name, option);
        const bool is_unnamed = name.columns.empty() && !scanner.has_header();
        while (scanner.next()) {
            if (is_unnamed) require_one_word(scanner, name, word);
            if (sizes.empty()) refuse_decimal_commas(scanner, found.column);
            sizes.push_back(parse_size(scanner, found.column, sizes.empty()));
            file.lines.push_back(scanner.line());
        }
        file.areas = sizes_of(sizes, found.kind, option);
        file.description = description(scanner, name, found);
    }
    if (sizes.empty()) {
        throw BadFile(name.path + ": holds no " + word + "; give one a line, one for each site");
    }
    return file;
}

}  // namespace

AreaFile parse_areas(const TableName& name, std::string_view text) {
    return parse_sizes(name, text, kAreaOption);
}

AreaFile parse_volumes(const TableName& name, std::string_view text) {
    return parse_sizes(name, text, kVolumeOption);
}

AreaFile read_areas(const TableName& name) {
    return parse_areas(name, read_whole_file(name.path, kSiteInput));
}

AreaFile read_volumes(const TableName& name) {
    return parse_volumes(name, read_whole_file(name.path, kSiteInput));
}

TableName volume_table(const std::string& text) {
    return parse_table_name(text, {"volume", "diameter", "radius"});
}

TableName area_table(const std::string& text) {
    return parse_table_name(text, {"area", "diameter", "radius"});
}

void require_areas(const AreaFile& file, int n_sites, const std::string& word) {
    require_one_row_a_site(file.name, file.lines, n_sites, word);
    Eigen::Index smallest = 0;
    const Eigen::VectorXd relative = file.areas / file.areas.maxCoeff();
    if (relative.minCoeff(&smallest) >= kLeastArea * relative.mean()) return;
    throw at_line(file, file.lines[static_cast<std::size_t>(smallest)],
                  "the " + word + " is below 1e-6 of the mean; give a larger one");
}

}  // namespace pcvt
