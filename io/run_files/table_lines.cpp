#include "io/run_files/table_lines.hpp"

#include <algorithm>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/char_set.hpp"
#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

constexpr CharSet kLineStops("\r\n#\"");
constexpr CharSet kFieldBlanks(" \t\v\f");
/// A tab at an end of a line may stand beside an empty field.
constexpr CharSet kLineBlanks(" \v\f");

std::string_view trimmed(std::string_view text, const CharSet& blanks) {
    text.remove_prefix(blanks.skip_in(text));
    while (!text.empty() && blanks.holds(text.back())) text.remove_suffix(1);
    return text;
}

bool is_between_digits(std::string_view text, std::size_t k) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    return k > 0 && k + 1 < text.size() && is_digit(text[k - 1]) && is_digit(text[k + 1]);
}

/// Whether blanks separate numbers with decimal commas: "1,5 2,5".
bool has_decimal_commas(std::string_view content) {
    std::size_t n_commas = 0;
    for (std::size_t k = 0; k < content.size(); ++k) {
        if (content[k] != ',') continue;
        ++n_commas;
        if (!is_between_digits(content, k)) return false;
    }
    return n_commas > 0 && kFieldBlanks.find_in(content) < content.size();
}

/// Whether each tab follows a comma, so that it separates nothing: "1,\t2".
bool tabs_follow_commas(std::string_view content) {
    for (std::size_t k = 0; k < content.size(); ++k) {
        if (content[k] != '\t') continue;
        const std::size_t before = content.find_last_not_of(" \t", k);
        if (before == std::string_view::npos || content[before] != ',') return false;
    }
    return true;
}

/// A line whose quoted parts are replaced by letters, so that no separator is in quotes.
std::string without_quoted_parts(std::string_view content) {
    std::string text(content);
    bool is_quoted = false;
    for (char& c : text) {
        if (c == '"') is_quoted = !is_quoted;
        if (is_quoted) c = 'q';
    }
    return text;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& fields) {
    while (true) {
        line.remove_prefix(kFieldBlanks.skip_in(line));
        if (line.empty()) return;
        const bool is_quoted = line.front() == '"';
        if (is_quoted) line.remove_prefix(1);
        const std::size_t length =
            is_quoted ? std::min(line.find('"'), line.size()) : kFieldBlanks.find_in(line);
        fields.push_back(line.substr(0, length));
        line.remove_prefix(std::min(length + (is_quoted ? 1 : 0), line.size()));
    }
}

void split_at(char separator, std::string_view line, std::vector<std::string_view>& fields) {
    bool is_quoted = false;
    std::size_t begin = 0;
    for (std::size_t k = 0; k <= line.size(); ++k) {
        if (k < line.size() && line[k] == '"') is_quoted = !is_quoted;
        if (k < line.size() && (is_quoted || line[k] != separator)) continue;
        fields.push_back(without_quotes(line.substr(begin, k - begin)));
        begin = k + 1;
    }
}

}  // namespace

TableLines::TableLines(std::string name, std::string_view text)
    : name_(std::move(name)), rest_(text) {
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool TableLines::next() {
    while (!rest_.empty()) {
        ++line_;
        std::size_t comment = std::string_view::npos;
        bool is_quoted = false;
        std::size_t end = kLineStops.find_in(rest_);
        while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') {
            if (comment == std::string_view::npos) {
                if (rest_[end] == '"') is_quoted = !is_quoted;
                if (rest_[end] == '#' && !is_quoted) comment = end;
            }
            ++end;
            end += kLineStops.find_in(rest_.substr(end));
        }
        content_ = trimmed(rest_.substr(0, std::min(comment, end)), kLineBlanks);
        const std::size_t n_ends = rest_.substr(end).starts_with("\r\n") ? 2 : 1;
        rest_.remove_prefix(std::min(end + n_ends, rest_.size()));
        if (is_quoted) refuse(line_, "a quote is not closed; close it, or remove it");
        if (kFieldBlanks.skip_in(content_) < content_.size()) return true;
    }
    return false;
}

void TableLines::refuse(int line, const std::string& complaint) const {
    throw BadFile(name_ + ":" + std::to_string(line) + ": " + complaint);
}

Separator separator_of(std::string_view content) {
    const std::string text = without_quoted_parts(content);
    if (text.find(';') != std::string::npos) return Separator::kSemicolon;
    const bool has_comma = text.find(',') != std::string::npos;
    if (text.find('\t') != std::string::npos && !(has_comma && tabs_follow_commas(text))) {
        return Separator::kTab;
    }
    return has_comma && !has_decimal_commas(text) ? Separator::kComma : Separator::kBlanks;
}

const char* separator_name(Separator separator) {
    switch (separator) {
        case Separator::kComma:
            return "commas";
        case Separator::kSemicolon:
            return "semicolons";
        case Separator::kTab:
            return "tabs";
        case Separator::kBlanks:
            break;
    }
    return "blanks";
}

std::string_view without_quotes(std::string_view field) {
    field = trimmed(field, kFieldBlanks);
    if (field.size() < 2 || field.front() != '"' || field.back() != '"') return field;
    return trimmed(field.substr(1, field.size() - 2), kFieldBlanks);
}

void split_fields(std::string_view content, Separator separator,
                  std::vector<std::string_view>& fields) {
    fields.clear();
    switch (separator) {
        case Separator::kBlanks:
            return split_at_blanks(content, fields);
        case Separator::kComma:
            return split_at(',', content, fields);
        case Separator::kSemicolon:
            return split_at(';', content, fields);
        case Separator::kTab:
            return split_at('\t', content, fields);
    }
}

}  // namespace pcvt
