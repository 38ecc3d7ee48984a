#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace pcvt {

/// Walks over the tokens of an OpenFOAM file: ( ) { } ; and words. It skips comments, and its
/// constructor reads the FoamFile header.
class FoamScanner {
   public:
    /// @param name  the file's name in messages.
    /// @param text  must outlive the scanner.
    /// @throws BadFile unless the file begins with a header and its format is ascii.
    FoamScanner(std::string name, std::string_view text);
    /// Returns a scanner in front of the header.
    static FoamScanner from_header(const std::string& name, std::string_view text) {
        return {name, text, 1};
    }

    /// Returns the next token; empty at the end of the text.
    std::string_view next();
    /// The line of the last token.
    int line() const { return line_; }
    /// Takes the next token.
    /// @throws BadFile unless it is `token`.
    void expect(std::string_view token);
    /// Return the next token as a number.
    /// @throws BadFile unless it is such a number.
    int integer();
    double number();
    /// Skips the rest of an entry, up to its semicolon.
    void skip_entry();
    /// Takes the length and the opening parenthesis of a list; returns the length. It is at most
    /// the number of characters left, so that the caller can safely reserve memory for it.
    int begin_list();

    /// @throws BadFile `name:line: complaint`.
    [[noreturn]] void throw_bad_file(const std::string& complaint) const;

   private:
    FoamScanner(std::string name, std::string_view text, int line)
        : name_(std::move(name)), rest_(text), line_(line) {}
    void skip_blanks();

    std::string name_;
    std::string_view rest_;
    int line_;
};

}  // namespace pcvt
