#include "io/run_files/yaml_reader.hpp"

#include <algorithm>

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kBlanks = " \t";
/// Deeper mappings are no materials; the reader calls itself for each.
constexpr int kDeepest = 32;
constexpr const char* kIndentation = "the indentation fits no line above; correct it";

bool is_yaml_blank(char c) { return kBlanks.find(c) != std::string_view::npos; }

/// Reads a text from its beginning to its end, line by line outside of braces.
class YamlReader {
   public:
    YamlReader(const std::string& name, std::string_view text, std::string_view section)
        : name_(name), text_(text), section_(section) {
        if (text_.starts_with(kByteOrderMark)) place_ = kByteOrderMark.size();
    }

    YamlValue read() {
        YamlValue file{.line = 1, .is_mapping = true};
        while (has_line() && (starts_with("%") || starts_with("---"))) {
            end_line();
            is_at_content_ = false;
        }
        const int indent = indent_;
        while (has_line() && !starts_with("...")) {
            if (starts_with("---")) refuse("a second document begins; give one");
            if (indent_ != indent) refuse(kIndentation);
            read_member(indent, 0, file);
        }
        return file;
    }

   private:
    [[noreturn]] void refuse(const std::string& complaint) const { refuse(line_, complaint); }
    [[noreturn]] void refuse(int line, const std::string& complaint) const {
        throw BadFile(name_ + ":" + std::to_string(line) + ": " + complaint);
    }

    bool at_end() const { return place_ == text_.size(); }
    char here() const { return text_[place_]; }
    bool at_line_end() const { return at_end() || here() == '\n' || here() == '\r'; }
    bool starts_with(std::string_view word) const { return text_.substr(place_).starts_with(word); }
    /// Whether a character ends a plain scalar or marks a list or a key: a blank must follow.
    bool is_mark(char c) const {
        return !at_end() && here() == c &&
               (place_ + 1 == text_.size() || text_.find_first_of(" \t\r\n", place_) == place_ + 1);
    }
    bool at_comment() const {
        return here() == '#' && (place_ == 0 || is_yaml_blank(text_[place_ - 1]) ||
                                 text_[place_ - 1] == '\n' || text_[place_ - 1] == '\r');
    }

    void skip_blanks() {
        while (!at_end() && is_yaml_blank(here())) ++place_;
    }
    /// Goes to the beginning of the next line.
    void end_line() {
        while (!at_line_end()) ++place_;
        if (at_end()) return;
        place_ += starts_with("\r\n") ? 2 : 1;
        ++line_;
    }
    /// Requires that a line holds nothing more than a comment, and ends it.
    void require_line_end() {
        skip_blanks();
        if (!at_line_end() && !at_comment()) {
            refuse(in_quotes(rest_of_line()) + " follows a value; write one value a line");
        }
        end_line();
    }
    std::string_view rest_of_line() const {
        const std::string_view rest = text_.substr(place_);
        return rest.substr(0, rest.find_first_of("\r\n"));
    }

    /// Goes to the first character of the next line with content, and finds its indentation.
    bool next_line() {
        while (!at_end()) {
            const std::size_t begin = place_;
            while (!at_end() && here() == ' ') ++place_;
            indent_ = static_cast<int>(place_ - begin);
            const bool has_tab = !at_end() && here() == '\t';
            skip_blanks();
            if (!at_line_end() && here() != '#') {
                if (has_tab) refuse("the line is indented by a tab; use blanks");
                return true;
            }
            end_line();
        }
        return false;
    }

    /// Reads the members of a block that are indented more than `above`; the reader is at the first
    /// one.
    void read_block(int above, int depth, YamlValue& mapping) {
        const int indent = indent_;
        do {
            if (indent_ != indent) {
                if (indent_ > above) refuse(kIndentation);
                return;
            }
            read_member(indent, depth, mapping);
        } while (has_line());
    }

    /// Whether the reader is at a line with content, to which it goes if it is at the beginning of
    /// one.
    bool has_line() {
        if (is_at_content_) return true;
        is_at_content_ = next_line();
        return is_at_content_;
    }

    void read_member(int indent, int depth, YamlValue& mapping) {
        is_at_content_ = false;
        if (depth > kDeepest) refuse("the mappings are too deep; give materials alone");
        const int line = line_;
        const std::string key = read_key();
        const bool is_read = depth > 0 || key == section_;
        YamlValue value = read_value(indent, depth, is_read);
        value.line = line;
        if (!is_read) return;
        if (mapping.find(key) != nullptr)
            refuse(line, in_quotes(key) + " is there twice; remove one");
        mapping.members.emplace_back(key, std::move(value));
    }

    std::string read_key() {
        const int line = line_;
        std::string key = read_scalar(false);
        skip_blanks();
        if (!is_mark(':')) {
            refuse(line,
                   in_quotes(key.empty() ? rest_of_line() : key) + " is no key; write KEY: VALUE");
        }
        ++place_;
        skip_blanks();
        return key;
    }

    YamlValue read_value(int indent, int depth, bool is_read) {
        if (!at_line_end() && !at_comment()) return read_line_value(indent, depth, is_read);
        end_line();
        // A block follows, a list perhaps as far left as its key, or the value is empty.
        YamlValue value;
        if (!has_line() || indent_ < indent || (indent_ == indent && !is_mark('-'))) return value;
        if (is_mark('-')) {
            value.is_list = true;
            skip_list(indent_);
        } else if (!is_read) {
            skip_deeper(indent);
        } else {
            value.is_mapping = true;
            read_block(indent, depth + 1, value);
        }
        return value;
    }

    YamlValue read_line_value(int indent, int depth, bool is_read) {
        YamlValue value;
        if (is_read) require_plain();
        if (here() == '|' || here() == '>') {
            end_line();
            skip_deeper(indent);
            return value;
        }
        if (here() == '{' || here() == '[') {
            value = read_flow(depth + 1);
        } else if (is_read) {
            value.text = read_scalar(false);
        } else {
            end_line();
            skip_deeper(indent);
            return value;
        }
        require_line_end();
        return value;
    }

    void require_plain() const {
        if (std::string_view("&*!").find(here()) == std::string_view::npos) return;
        refuse("anchors, aliases and tags are not supported; write the value out");
    }

    /// Skips the lines that are indented more.
    void skip_deeper(int indent) {
        while (has_line() && indent_ > indent) {
            end_line();
            is_at_content_ = false;
        }
    }
    /// Skips the items of a list and what belongs to them.
    void skip_list(int indent) {
        while (has_line() && (indent_ > indent || (indent_ == indent && is_mark('-')))) {
            end_line();
            is_at_content_ = false;
        }
    }

    /// Reads a scalar; a plain one ends before ": ", before " #" and at the end of the line, and in
    /// braces also before , { } [ and ].
    std::string read_scalar(bool in_flow) {
        if (!at_end() && (here() == '"' || here() == '\'')) return read_quoted();
        const std::size_t begin = place_;
        while (!at_line_end() && !is_mark(':') && !at_comment()) {
            if (in_flow && std::string_view(",{}[]").find(here()) != std::string_view::npos) break;
            ++place_;
        }
        std::string_view word = text_.substr(begin, place_ - begin);
        while (!word.empty() && is_yaml_blank(word.back())) word.remove_suffix(1);
        return std::string(word);
    }

    std::string read_quoted() {
        const char quote = here();
        std::string word;
        for (++place_; !at_line_end(); ++place_) {
            if (here() == '\\' && quote == '"') {
                refuse("\\ in quotes is not supported; write the character itself");
            }
            if (here() != quote) {
                word += here();
                continue;
            }
            ++place_;
            // Two quotes are one.
            if (quote != '\'' || at_end() || here() != quote) return word;
            word += quote;
        }
        refuse("the quotes are not closed in this line; close them");
    }

    /// Goes to the next character in braces that is neither blank nor in a comment.
    void skip_flow_blanks() {
        while (!at_end()) {
            skip_blanks();
            if (!at_line_end() && !at_comment()) return;
            end_line();
        }
        refuse("a brace is not closed; close it");
    }

    YamlValue read_flow(int depth) {
        if (depth > kDeepest) refuse("the mappings are too deep; give materials alone");
        const bool is_list = here() == '[';
        YamlValue value{.line = line_, .is_mapping = !is_list, .is_list = is_list};
        const char end = is_list ? ']' : '}';
        ++place_;
        while (true) {
            skip_flow_blanks();
            if (here() == end) break;
            if (is_list) {
                read_flow_value(depth);
            } else {
                read_flow_member(depth, value);
            }
            skip_flow_blanks();
            if (here() == end) break;
            if (here() != ',') refuse("a comma is missing between braces; add it");
            ++place_;
        }
        ++place_;
        return value;
    }

    void read_flow_member(int depth, YamlValue& mapping) {
        const int line = line_;
        std::string key = read_scalar(true);
        skip_flow_blanks();
        if (here() != ':' || key.empty()) {
            refuse(line, in_quotes(key) + " is no key; write {KEY: VALUE, ...}");
        }
        ++place_;
        skip_flow_blanks();
        YamlValue value = read_flow_value(depth);
        value.line = line;
        if (mapping.find(key) != nullptr)
            refuse(line, in_quotes(key) + " is there twice; remove one");
        mapping.members.emplace_back(std::move(key), std::move(value));
    }

    YamlValue read_flow_value(int depth) {
        if (here() == '{' || here() == '[') return read_flow(depth + 1);
        require_plain();
        const std::size_t begin = place_;
        YamlValue value{.text = read_scalar(true), .line = line_};
        if (place_ == begin && here() != ',' && here() != '}' && here() != ']') {
            refuse("a value in braces is not closed; correct it");
        }
        return value;
    }

    const std::string& name_;
    std::string_view text_;
    std::string_view section_;
    std::size_t place_ = 0;
    int line_ = 1;
    /// Of the line at whose first character next_line() has put the reader.
    int indent_ = 0;
    bool is_at_content_ = false;
};

}  // namespace

const YamlValue* YamlValue::find(std::string_view key) const {
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&](const auto& member) { return member.first == key; });
    return found == members.end() ? nullptr : &found->second;
}

YamlValue parse_yaml(const std::string& name, std::string_view text, std::string_view section) {
    refuse_binary(name, text, "give a text in YAML");
    return YamlReader(name, text, section).read();
}

}  // namespace pcvt
