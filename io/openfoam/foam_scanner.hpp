#pragma once

#include <string>
#include <string_view>

namespace pcvt {

/// Walks over the tokens of an OpenFOAM file: ( ) { } ; and words. Comments are passed over, and
/// the FoamFile header is read by the constructor.
class FoamScanner {
   public:
    /// @param name  the file's name in messages.
    /// @param text  must outlive the scanner.
    /// @throws BadFile unless the file begins with a header and its format is ascii.
    FoamScanner(std::string name, std::string_view text);

    /// The next token; at the end of the text empty.
    std::string_view next();
    /// Takes the next token.
    /// @throws BadFile unless it is `token`, or a number.
    void expect(std::string_view token);
    int integer();
    double number();
    /// Passes over the rest of an entry, to its semicolon.
    void skip_entry();
    /// Begins a list: its length, and its opening parenthesis. The length is checked against what
    /// is left of the text, so that it can be reserved.
    int begin_list();

    /// @throws BadFile `name:line: complaint`.
    [[noreturn]] void throw_bad_file(const std::string& complaint) const;

   private:
    void skip_blanks();

    std::string name_;
    std::string_view rest_;
    int line_ = 1;
};

}  // namespace pcvt
