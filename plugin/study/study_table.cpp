#include "plugin/study/study_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "io/bytes/text.hpp"
#include "mesher/base/error.hpp"
#include "mesher/portable/decimal_text.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kComment = "# ";
/// No run gives larger numbers, nor smaller ones than its inverse except for 0: pictures could not
/// show them.
constexpr double kLargest = 1e100;

void append_cells(std::string& text, const StudyRow& cells) {
    for (std::size_t k = 0; k < cells.size(); ++k) {
        if (cells[k].find_first_of(",\"\n\r") != std::string::npos) {
            throw InternalError("a cell of a table holds '" + cells[k] + "'");
        }
        text += k == 0 ? "" : ",";
        text += cells[k];
    }
    text += '\n';
}

StudyRow cut_at_commas(std::string_view line) {
    StudyRow cells;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        cells.emplace_back(line.substr(begin, end - begin));
        begin = end + 1;
    }
    return cells;
}

std::string_view without_return(std::string_view line) {
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

}  // namespace

std::size_t StudyTable::column(const std::string& name) const {
    const auto found = std::find(columns.begin(), columns.end(), name);
    if (found == columns.end()) throw InternalError("a table has no column '" + name + "'");
    return static_cast<std::size_t>(found - columns.begin());
}

double StudyTable::number(const StudyRow& row, const std::string& name) const {
    const std::string& word = row.at(column(name));
    try {
        const double value = parse_number(word);
        const double size = std::abs(value);
        if (size == 0 || (size >= 1 / kLargest && size <= kLargest)) return value;
        throw InvalidInput(in_quotes(word) +
                           " is not a figure of a run; the table is damaged, make it again");
    } catch (const InvalidInput& error) {
        throw InvalidInput("column " + name + ": " + error.what());
    }
}

std::string encode_csv(const StudyTable& table) {
    std::string text;
    for (const std::string& note : table.notes) text.append(kComment).append(note) += '\n';
    for (const std::string& remark : table.remarks) text.append(kComment).append(remark) += '\n';
    append_cells(text, table.columns);
    for (const StudyRow& row : table.rows) append_cells(text, row);
    return text;
}

StudyTable decode_csv(const std::string& name, const std::string& text) {
    refuse_binary(name, text, "give a .csv file of pcvt study --shard");
    StudyTable table;
    int line_number = 0;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line =
            without_return(std::string_view(text).substr(begin, end - begin));
        begin = end + 1;
        ++line_number;
        if (line.empty()) continue;
        if (line.starts_with('#')) {
            table.notes.emplace_back(line.substr(std::min(line.size(), kComment.size())));
        } else if (table.columns.empty()) {
            table.columns = cut_at_commas(line);
        } else {
            table.rows.push_back(cut_at_commas(line));
            if (table.rows.back().size() != table.columns.size()) {
                throw BadFile(name + ":" + std::to_string(line_number) + ": " +
                              std::to_string(table.rows.back().size()) + " cells under " +
                              std::to_string(table.columns.size()) +
                              " columns; the file is damaged, make it again");
            }
        }
    }
    return table;
}

std::string aligned_text(const StudyTable& table, std::size_t most_columns) {
    const std::size_t n_columns = std::min(most_columns, table.columns.size());
    std::vector<std::size_t> width(n_columns);
    for (std::size_t c = 0; c < n_columns; ++c) {
        width[c] = table.columns[c].size();
        for (const StudyRow& row : table.rows) width[c] = std::max(width[c], row[c].size());
    }
    std::string text;
    const auto append = [&](const StudyRow& cells) {
        for (std::size_t c = 0; c < n_columns; ++c) {
            text.append(width[c] - cells[c].size() + (c == 0 ? 0 : 2), ' ').append(cells[c]);
        }
        text += '\n';
    };
    append(table.columns);
    for (const StudyRow& row : table.rows) append(row);
    for (const std::string& remark : table.remarks) text.append(remark) += '\n';
    return text;
}

std::string in_full(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

std::string rounded(double value, int digits) {
    if (!std::isfinite(value)) throw InternalError("a number of a table is not finite");
    std::array<char, 64> text{};
    char* const end =
        write_decimal(text.begin(), text.end(), value + 0.0, std::chars_format::general, digits);
    return {text.begin(), end};
}

}  // namespace pcvt
