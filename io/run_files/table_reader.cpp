#include "io/run_files/table_reader.hpp"

#include <algorithm>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/run_files/table_hints.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kMostListed = 12;
constexpr std::string_view kStatedSeparator = "sep=";

/// Whether the comma of a number may stand between thousands: 1,234, but neither 0,123 nor 1,5.
bool may_separate_thousands(std::string_view number) {
    if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
    const std::size_t comma = number.find(',');
    return comma >= 1 && comma <= 3 && number[0] != '0' && number.size() == comma + 4 &&
           number.find_first_not_of("0123456789,") == std::string_view::npos;
}

bool is_whole_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool has_name(const TableColumn& column, const TableColumn& wanted) {
    return comparable_name(column.name) == comparable_name(wanted.name) &&
           (wanted.unit.empty() || column.unit == wanted.unit);
}

}  // namespace

TableScanner::TableScanner(std::string name, std::string_view text, bool has_header)
    : lines_(std::move(name), text) {
    read_header(has_header);
}

void TableScanner::read_header(bool may_be_header) {
    TableLines first = lines_;
    if (!first.next()) return;
    if (first.content().starts_with(kStatedSeparator) &&
        first.content().size() == kStatedSeparator.size() + 1) {
        lines_ = first;
        if (!first.next()) return;
    }
    if (may_be_header) refuse_atom_files(first);
    const auto split = [&](std::string_view content) {
        separator_ = separator_of(content);
        split_fields(content, separator_, fields_);
    };
    TableLines second = first;
    if (is_whole_number(first.content()) && second.next()) {
        // A number of rows may stand above a header of several columns.
        split(second.content());
        if (fields_.size() > 1 && is_header(fields_)) first = second;
    }
    split(first.content());
    header_line_ = first.line();
    if (may_be_header && is_header(fields_)) return join_header(first);
    const bool has_comma = first.content().find(',') != std::string_view::npos;
    if (separator_ == Separator::kTab && !has_comma) {
        separator_ = Separator::kBlanks;
        split_fields(first.content(), separator_, fields_);
    }
    if (fields_.size() > 1 && fields_.back().empty()) fields_.pop_back();
    n_columns_ = fields_.size();
}

/// Sets the header. A single name may hold blanks: then the first row has one field.
void TableScanner::join_header(const TableLines& header) {
    header_ = header_columns(fields_, separator_);
    if (header_.size() > 1 && fields_.back().empty()) header_.pop_back();
    lines_ = header;
    TableLines row = header;
    if (row.next()) {
        row_below_header_ = row.line();
        split_fields(row.content(), separator_, fields_);
        if (separator_ == Separator::kBlanks && header_.size() > 1 && fields_.size() == 1) {
            header_ = {header_column(header.content())};
        }
        split_fields(row.content(), separator_of(row.content()), fields_);
        may_be_title_ = fields_.size() > 1 && is_header(fields_);
    }
    n_columns_ = header_.size();
    names_columns_ = n_columns_ > 1;
    requires_width_ = true;
}

std::optional<std::size_t> TableScanner::find(std::string_view column) const {
    const TableColumn wanted = header_column(column);
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < header_.size(); ++k) {
        if (!has_name(header_[k], wanted)) continue;
        if (found) {
            refuse_header("columns " + std::to_string(*found + 1) + " and " +
                          std::to_string(k + 1) + " are both called " + in_quotes(wanted.name) +
                          "; rename one, or name columns by their numbers");
        }
        found = k;
    }
    return found;
}

std::vector<std::size_t> TableScanner::choose(const std::vector<std::string>& columns) {
    std::vector<std::size_t> chosen;
    for (const std::string& column : columns) {
        if (const std::optional<std::size_t> found = find(column)) {
            chosen.push_back(*found);
            continue;
        }
        const int number = is_whole_number(column) ? parse_integer(column) : 0;
        if (number < 1 || number > static_cast<int>(n_columns_)) {
            refuse_header("there is no column " + in_quotes(column) + "; " +
                          (has_header() ? "take one of " + listed_columns()
                                        : "take a number from 1 to " + std::to_string(n_columns_)));
        }
        chosen.push_back(static_cast<std::size_t>(number) - 1);
    }
    names_columns_ = names_columns_ || !has_header();
    requires_width_ = true;
    return chosen;
}

bool TableScanner::next() {
    checkpoint();
    const auto is_empty = [](std::string_view field) { return field.empty(); };
    bool is_row = true;
    do {
        is_row = lines_.next();
        if (is_row) split_fields(lines_.content(), separator_, fields_);
    } while (is_row && std::all_of(fields_.begin(), fields_.end(), is_empty));
    if (!is_row) {
        if (unclear_line_ == 0 || has_clear_comma_) return false;
        lines_.refuse(unclear_line_,
                      "the comma may be a decimal mark or stand between thousands; write a decimal "
                      "point, or no separators of thousands");
    }
    const bool ends_empty = fields_.size() > 1 && fields_.back().empty();
    if (ends_empty && (!requires_width_ || fields_.size() == n_columns_ + 1)) fields_.pop_back();
    if (requires_width_ && fields_.size() != n_columns_) refuse_width();
    return true;
}

double TableScanner::number(std::size_t column) {
    const std::string_view field = fields_[column];
    if (field.empty()) refuse(column, "the field is empty; give a number");
    const bool is_only_column = header_.size() == 1;
    if (separator_ == Separator::kSemicolon || separator_ == Separator::kTab || is_only_column) {
        return decimal_number(column, field);
    }
    try {
        return parse_number(field);
    } catch (const InvalidInput& fault) {
        refuse_near_number(column, field);
        if (separator_ == Separator::kComma && field.find(',') != std::string_view::npos) {
            refuse(column, in_quotes(field) +
                               " is not a number; write a decimal point, and no "
                               "separators of thousands");
        }
        refuse(column, fault.what());
    }
}

/// Refuses a field that is nearly a number, and one of a row of units below the header.
void TableScanner::refuse_near_number(std::size_t column, std::string_view field) const {
    if (const std::string remedy = number_remedy(field); !remedy.empty()) {
        refuse(column, in_quotes(field) + " is not a number" + remedy);
    }
    if (lines_.line() != row_below_header_ || fields_.size() < 2 || !is_header(fields_)) return;
    refuse(column, in_quotes(field) +
                       " is not a number; remove the row, or put units in brackets behind the "
                       "names of the columns");
}

/// Reads a number with either decimal mark, which is that of the whole table.
double TableScanner::decimal_number(std::size_t column, std::string_view field) {
    const auto is_mark = [](char c) { return c == ',' || c == '.'; };
    const auto n_marks = std::count_if(field.begin(), field.end(), is_mark);
    if (n_marks > 1) {
        refuse(column, in_quotes(field) + " has " + std::to_string(n_marks) +
                           " decimal marks; write one, and no separators of thousands");
    }
    std::string digits(field);
    std::replace(digits.begin(), digits.end(), ',', '.');
    double value = 0;
    try {
        value = parse_number(digits);
    } catch (const InvalidInput& fault) {
        refuse_near_number(column, field);
        if (digits == field) refuse(column, fault.what());
        refuse(column, in_quotes(field) + " is not a number; write a decimal such as -1,5e3");
    }
    if (n_marks == 0) return value;
    const char mark = *std::find_if(field.begin(), field.end(), is_mark);
    if (mark_ == 0) {
        mark_ = mark;
        mark_line_ = line();
    } else if (mark != mark_) {
        refuse(column, in_quotes(field) + " has a decimal " + (mark == ',' ? "comma" : "point") +
                           ", a number of line " + std::to_string(mark_line_) + " has a " +
                           (mark == ',' ? "point" : "comma") + "; write all numbers alike");
    }
    if (mark == ',' && may_separate_thousands(field)) {
        if (unclear_line_ == 0) unclear_line_ = line();
    } else if (mark == ',') {
        has_clear_comma_ = true;
    }
    return value;
}

std::string_view TableScanner::word(std::size_t column) const {
    const std::string_view field = fields_[column];
    if (field.empty()) refuse(column, "the field is empty; fill it");
    return field;
}

void TableScanner::refuse(const std::string& complaint) const {
    lines_.refuse(lines_.line(), complaint);
}

void TableScanner::refuse(std::size_t column, const std::string& complaint) const {
    refuse(names_columns_ ? label(column) + ": " + complaint : complaint);
}

void TableScanner::refuse_header(const std::string& complaint) const {
    lines_.refuse(header_line_, complaint);
}

void TableScanner::refuse_width() const {
    const std::size_t n = fields_.size();
    const bool has_more = n > n_columns_;
    std::string complaint = "the row has " + std::to_string(n) + (n == 1 ? " field" : " fields") +
                            " with " + separator_name(separator_) + " between them, but the " +
                            (has_header() ? "header" : "first row") + " has " +
                            std::to_string(n_columns_) + "; ";
    if (has_more && separator_ == Separator::kComma) {
        complaint +=
            "correct the row, or where commas are decimal marks write semicolons between fields";
    } else {
        complaint +=
            has_more ? "remove the others, or extend the header" : "give one field for each column";
    }
    refuse(complaint);
}

std::string TableScanner::label(std::size_t column) const {
    const bool has_label = column < header_.size() && !header_[column].name.empty();
    return "column " + (has_label ? in_quotes(header_[column].name) : std::to_string(column + 1));
}

std::string TableScanner::typed(std::size_t column) const {
    std::string number = std::to_string(column + 1);
    if (column >= header_.size()) return number;
    const std::string& name = header_[column].name;
    const auto n = std::count_if(header_.begin(), header_.end(), [&](const TableColumn& other) {
        return comparable_name(other.name) == comparable_name(name);
    });
    const bool is_shown = in_quotes(name) == "'" + name + "'";
    const bool is_plain = !name.empty() && name.find_first_of(",:'") == std::string::npos;
    return n == 1 && is_shown && is_plain ? name : number;
}

std::string TableScanner::listed_columns() const {
    std::string text;
    for (std::size_t k = 0; k < std::min(header_.size(), kMostListed); ++k) {
        text += (k == 0 ? "" : ", ") + in_quotes(header_[k].name);
    }
    if (header_.size() > kMostListed) text += ", ...";
    return text + title_remedy();
}

std::string TableScanner::title_remedy() const {
    return may_be_title_ ? " (if this is a title, remove the lines above the header)" : "";
}

std::string place_in_words(const TableScanner& scanner, const TableName& name, std::size_t column) {
    std::string file = " of " + name.path;
    if (!scanner.has_header() && name.columns.empty()) return file;
    const TableColumn named = scanner.has_header()
                                  ? scanner.header()[column]
                                  : TableColumn{.name = std::to_string(column + 1)};
    const std::string quoted = in_quotes(named.name);
    return " of column " + quoted.substr(1, quoted.size() - 2) +
           (named.unit.empty() ? "" : " (" + named.unit + ")") + file;
}

void require_one_row_a_site(const std::string& name, const std::vector<int>& lines, int n_sites,
                            const std::string& quantity) {
    const auto n = static_cast<int>(lines.size());
    if (n == n_sites) return;
    const int line = n < n_sites ? lines.back() : lines[static_cast<std::size_t>(n_sites)];
    throw BadFile(name + ":" + std::to_string(line) + ": " +
                  (n < n_sites ? "the last of " + std::to_string(n) + " " + quantity + "s"
                               : quantity + " " + std::to_string(n_sites + 1)) +
                  ", but there are " + std::to_string(n_sites) + " sites; give one " + quantity +
                  " for each site");
}

}  // namespace pcvt
