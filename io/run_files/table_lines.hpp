#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcvt {

/// What stands between the fields of a row.
enum class Separator { kBlanks, kComma, kSemicolon, kTab };

/// Walks over the lines of a table that hold more than blanks and a comment, which begins with #
/// outside of quotes. LF, CRLF and CR end a line; a UTF-8 byte order mark is skipped.
///
/// Example usage:
///     TableLines lines("ebsd.csv", text);
///     while (lines.next()) split_fields(lines.content(), Separator::kComma, fields);
class TableLines {
   public:
    /// @param name  the file's name in messages.
    /// @param text  must outlive the lines.
    TableLines(std::string name, std::string_view text);

    /// Advances to the next line with content; returns false at the end.
    /// @throws BadFile if a quote is not closed on its line.
    bool next();
    /// The current line without its comment and the blanks round it, but with tabs.
    std::string_view content() const { return content_; }
    /// The number of the current line, counted from 1.
    int line() const { return line_; }
    const std::string& name() const { return name_; }
    /// @throws BadFile `name:line: complaint`.
    [[noreturn]] void refuse(int line, const std::string& complaint) const;

   private:
    std::string name_;
    std::string_view rest_;
    std::string_view content_;
    int line_ = 0;
};

/// Returns the separator of a line: a semicolon; else a tab, unless it follows a comma; else a
/// comma, unless words with decimal commas have blanks between them; else blanks.
Separator separator_of(std::string_view content);

/// The separator for messages: "commas".
const char* separator_name(Separator separator);

/// A field without the blanks and the pair of quotes round it.
std::string_view without_quotes(std::string_view field);

/// Replaces `fields` by the fields of a line, without the blanks and the quotes round them.
/// Separators in quotes are a part of their field. Between blanks, no field is empty.
void split_fields(std::string_view content, Separator separator,
                  std::vector<std::string_view>& fields);

}  // namespace pcvt
