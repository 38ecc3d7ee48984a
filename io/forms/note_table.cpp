#include "io/forms/note_table.hpp"

#include <algorithm>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {

void append_lines(std::string& text, std::string_view mark, std::string_view lines) {
    while (!lines.empty()) {
        const std::size_t length = lines.find('\n') + 1;
        (text += mark) += lines.substr(0, length);
        lines.remove_prefix(length);
    }
}

void append_note(std::string& text, std::string_view mark, const NoteTable& note, int index_base) {
    if (note.word.empty()) return;
    const std::size_t width = note.width > 0 ? note.width : kSitesALine;
    std::visit(
        [&](const auto& numbers) {
            for (std::size_t begin = 0; begin < numbers.size(); begin += width) {
                checkpoint_each(static_cast<long>(begin / width));
                (text += mark) += note.word;
                const std::size_t n = std::min(width, numbers.size() - begin);
                for (std::size_t k = 0; k < n; ++k) {
                    text += ' ';
                    append_number(text, numbers[begin + k] + (k < note.n_indices ? index_base : 0));
                }
                text += '\n';
            }
        },
        note.numbers);
}

bool take_note_line(std::span<NoteTable> notes, const LineScanner& scanner, std::string_view word,
                    std::span<const std::string_view> numbers, int index_base) {
    const auto note = std::find_if(notes.begin(), notes.end(),
                                   [&](const NoteTable& known) { return known.word == word; });
    if (note == notes.end()) return false;
    if (note->width > 0 && numbers.size() != note->width) {
        scanner.throw_bad_file(std::string(word) + " has " + std::to_string(note->width) +
                               " numbers here, not " + std::to_string(numbers.size()) +
                               "; write the file again with pcvt");
    }
    if (auto* const reals = std::get_if<std::vector<double>>(&note->numbers)) {
        for (const std::string_view number : numbers) reals->push_back(scanner.number(number));
        return true;
    }
    auto& integers = std::get<std::vector<int>>(note->numbers);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const int number = scanner.integer(numbers[k]);
        const int base = k < note->n_indices ? index_base : 0;
        if (base > number && k < note->n_indices) {
            scanner.throw_bad_file("index " + std::to_string(number) +
                                   " does not exist; count from " + std::to_string(base));
        }
        integers.push_back(number - base);
    }
    return true;
}

}  // namespace pcvt
