#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/text.hpp"

namespace pcvt {

/// The dimensions of Gmsh's entities.
inline constexpr int kMshCurves = 1;
inline constexpr int kMshSurfaces = 2;

/// Walks over the rows of an MSH file, which are its lines that are not blank.
///
/// Example usage:
///     const int n = (rows.next_row(1), rows.count(0));
///     for (int k = 0; k < n; ++k) tags.push_back((rows.next_row(4), rows.integer(0)));
class MshRows {
   public:
    using Words = std::vector<std::string_view>;

    /// @param text  must outlive this object.
    MshRows(const std::string& name, std::string_view text) : name_(name), scanner_(name, text) {}

    const LineScanner& scanner() const { return scanner_; }
    const Words& words() const { return scanner_.words(); }
    int line() const { return scanner_.line(); }

    /// Advances to the next row; returns false at the end of the text.
    bool next_filled() {
        while (scanner_.next()) {
            if (!scanner_.words().empty()) return true;
        }
        return false;
    }
    /// Returns the words of the next row of a section.
    /// @throws BadFile  at the end of the text.
    const Words& next_row() {
        if (!next_filled()) {
            throw BadFile(name_ + ": ends inside of a section; give the whole file");
        }
        return scanner_.words();
    }
    /// @throws BadFile  also where the row has another number of words.
    const Words& next_row(std::size_t n_words) {
        if (next_row().size() != n_words) {
            scanner_.throw_bad_file("the line has " + std::to_string(scanner_.words().size()) +
                                    " words where " + std::to_string(n_words) +
                                    " belong; write the file again");
        }
        return scanner_.words();
    }
    int integer(std::size_t word) const { return scanner_.integer(scanner_.words()[word]); }
    double number(std::size_t word) const { return scanner_.number(scanner_.words()[word]); }
    int count(std::size_t word) const {
        const int n = integer(word);
        if (n < 0) scanner_.throw_bad_file("a count is negative; correct it");
        return n;
    }
    [[noreturn]] void throw_bad_file(const std::string& complaint) const {
        scanner_.throw_bad_file(complaint);
    }

   private:
    std::string name_;
    LineScanner scanner_;
};

}  // namespace pcvt
