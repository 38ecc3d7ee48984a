#include "io/run_files/orientation_list.hpp"

#include <charconv>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "io/run_files/table_lines.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kAngleCount = "Angle Count:";
/// A line of VPSC states the convention of the angles and the number of orientations.
constexpr int kLineOfVpsc = 4;

std::optional<std::int64_t> whole_number(std::string_view text) {
    std::int64_t number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc() || end != text.data() + text.size() || number < 0) return std::nullopt;
    return number;
}

/// The text behind its line `line`, with blanks in place of the lines up to it.
std::string without_lines(std::string_view text, int line) {
    std::string rows(text);
    for (std::size_t k = 0; k < rows.size() && line > 0; ++k) {
        const bool ends_line = rows[k] == '\n' || (rows[k] == '\r' && text.substr(k, 2) != "\r\n");
        if (ends_line) {
            --line;
        } else if (rows[k] != '\r') {
            rows[k] = ' ';
        }
    }
    return rows;
}

std::optional<ListHead> head_of_dream3d(std::string_view text, const TableLines& first) {
    if (!first.content().starts_with(kAngleCount)) return std::nullopt;
    const auto n_rows = whole_number(without_quotes(first.content().substr(kAngleCount.size())));
    if (!n_rows) return std::nullopt;
    const std::string_view comments = text.substr(0, text.find(kAngleCount));
    const auto states = [&](const char* words) {
        return comments.find(words) != std::string_view::npos;
    };
    const AngleUnit unit = states("expressed in degrees")   ? AngleUnit::kDegrees
                           : states("expressed in radians") ? AngleUnit::kRadians
                                                            : AngleUnit::kGuessed;
    return ListHead{*n_rows, unit, without_lines(text, first.line())};
}

std::optional<ListHead> head_of_vpsc(std::string_view text, TableLines lines) {
    bool has_more = true;
    while (has_more && lines.line() < kLineOfVpsc) has_more = lines.next();
    if (lines.line() != kLineOfVpsc) return std::nullopt;
    std::vector<std::string_view> words;
    split_fields(lines.content(), Separator::kBlanks, words);
    if (words.size() != 2 || words[0].size() != 1) return std::nullopt;
    const char convention = words[0].front();
    const auto n_rows = whole_number(words[1]);
    if (!n_rows || std::string_view("BKR").find(convention) == std::string_view::npos) {
        return std::nullopt;
    }
    if (convention != 'B') {
        lines.refuse(lines.line(), std::string("the angles are those of ") +
                                       (convention == 'K' ? "Kocks" : "Roe") +
                                       "; export Bunge's angles, which begin with B");
    }
    return ListHead{*n_rows, AngleUnit::kGuessed, without_lines(text, kLineOfVpsc)};
}

}  // namespace

std::optional<ListHead> list_head(const std::string& name, std::string_view text) {
    TableLines first(name, text);
    if (!first.next()) return std::nullopt;
    if (auto head = head_of_dream3d(text, first)) return head;
    return head_of_vpsc(text, TableLines(name, text));
}

}  // namespace pcvt
