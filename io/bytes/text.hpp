#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/bad_file.hpp"

namespace pcvt {

/// Appends the shortest decimals that read back as `value`, whatever the locale; -0.0 is written 0.
/// @throws InternalError if value is not finite: no text format of ours has a word for that.
void append_number(std::string& text, double value);
void append_number(std::string& text, int value);

/// The number that the whole of `word` spells: decimal, a leading + allowed; no hex, NaN or
/// infinity.
/// @throws InvalidInput `'1,5' is not a number; use a decimal point`, and the like.
double parse_number(std::string_view word);
int parse_integer(std::string_view word);

/// `word` between quotes for a message: at most 40 characters, unprintable bytes as question marks.
std::string in_quotes(std::string_view word);

/// Walks over the lines of a text. Lines end with LF, CRLF or CR, the last one also with the text;
/// a UTF-8 byte order mark at the beginning is passed over.
class LineScanner {
   public:
    /// @param name  the file's name in messages.
    /// @param text  must outlive the scanner.
    LineScanner(std::string name, std::string_view text);

    /// Steps to the next line; false at the end of the text.
    bool next();
    /// Number of the current line, from 1; 0 before the first next().
    int line() const { return line_; }
    /// The current line, cut at blanks and tabs.
    const std::vector<std::string_view>& words() const { return words_; }

    /// parse_number and parse_integer with the place of the fault before the message.
    /// @throws BadFile `name:line: what; what to do`.
    double number(std::string_view word) const;
    int integer(std::string_view word) const;
    /// @throws BadFile `name:line: complaint`.
    [[noreturn]] void throw_bad_file(const std::string& complaint) const;

   private:
    std::string name_;
    std::string_view rest_;
    std::vector<std::string_view> words_;
    int line_ = 0;
};

/// @throws BadFile `name: looks like a binary file; remedy` if the text holds a NUL byte.
void refuse_binary(const std::string& name, std::string_view text, const std::string& remedy);

/// All bytes of the file; standard input where `path` is "-" and `or_standard_input` is set.
/// @throws BadFile `path: cannot read: reason; give a readable file`.
std::string read_whole_file(const std::string& path, bool or_standard_input = false);

/// Whether the file consists of exactly these bytes. It is read block by block: a second copy of a
/// large file in memory would cost more than the reading.
/// @throws BadFile as read_whole_file().
bool file_holds(const std::string& path, std::string_view bytes);

}  // namespace pcvt
