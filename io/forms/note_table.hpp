#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/bytes/text.hpp"

namespace pcvt {

/// The items that have a row each in a note, by which formats with properties store it beside them.
enum class NoteOf { kMesh, kVertices, kFaces, kSites };

/// Lists of numbers have at most this many on a line.
inline constexpr std::size_t kSitesALine = 16;

/// One quantity that a file states beside its points and faces: a table of numbers.
///
/// Example usage:
///     const NoteTable pairs{.word = "vertex_pair", .width = 4, .n_indices = 2,
///                             .numbers = std::vector{0, 3, 1, 1}};
///     append_note(text, "# pcvt ", pairs, 1);  // "# pcvt vertex_pair 1 4 1 1"
struct NoteTable {
    /// The word at the head of its lines; empty: files with lines do not state it.
    std::string word = {};
    /// The names of its columns, "orbit offset_i offset_j"; empty: it is not a property.
    std::string columns = {};
    NoteOf of = NoteOf::kMesh;
    /// The numbers of a row, which is a line; 0: one list, kSitesALine numbers a line.
    std::size_t width = 0;
    /// The first numbers of a line are this many indices, which a file counts from its own base.
    std::size_t n_indices = 0;
    std::variant<std::vector<int>, std::vector<double>> numbers = {};

    const std::vector<int>& integers() const { return std::get<std::vector<int>>(numbers); }
    const std::vector<double>& reals() const { return std::get<std::vector<double>>(numbers); }
};

/// Appends lines, each behind `mark`.
void append_lines(std::string& text, std::string_view mark, std::string_view lines);

/// Appends the lines `MARKword number number ...` of a note; none without a word or numbers.
/// @param index_base  the number that the file gives to index 0.
void append_note(std::string& text, std::string_view mark, const NoteTable& note, int index_base);

/// Appends the numbers of a line to the note of this word.
/// @returns whether there is one.
/// @throws BadFile  with the line: there are more or fewer numbers than the width, or an index lies
///                  below the base.
bool take_note_line(std::span<NoteTable> notes, const LineScanner& scanner, std::string_view word,
                    std::span<const std::string_view> numbers, int index_base);

/// Takes the words of a comment of pcvt: its first word and the others.
/// @returns whether the first word is known.
using NoteTaker = std::function<bool(const LineScanner& scanner, std::string_view word,
                                     std::span<const std::string_view> words)>;

}  // namespace pcvt
