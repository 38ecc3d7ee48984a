#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/char_set.hpp"

namespace pcvt {

/// Walks over the tags of a plain XML text: elements with attributes and text. Comments and
/// declarations are skipped. Entities, CDATA and DTD are not supported; VTK's files do not use
/// them.
///
/// Example usage:
///     using Event = XmlScanner::Event;
///     XmlScanner scanner("grid.vtu", text);
///     for (Event event = scanner.next(); event != Event::kNothing; event = scanner.next()) {
///         if (event == Event::kBegin) names.emplace_back(scanner.element());
///     }
class XmlScanner {
   public:
    enum class Event { kBegin, kEnd, kNothing };

    /// @param name  the file's name in messages.
    /// @param text  must outlive the scanner.
    XmlScanner(std::string name, std::string_view text);

    /// Advances to the next tag; an element without content, `<a/>`, begins and ends. Returns
    /// kNothing after the last tag.
    /// @throws BadFile with the line if the text is not XML or its tags do not nest.
    Event next();
    /// The name of the element that begins or ends here.
    std::string_view element() const { return element_; }
    /// The value of an attribute of the element that begins here; `nullopt` if it has none.
    std::optional<std::string_view> attribute(std::string_view key) const;
    /// The text between the previous tag and the current one.
    std::string_view text() const { return content_; }
    /// The line of the current tag.
    int line() const { return line_; }
    const std::string& name() const { return name_; }

    /// Calls `handle(word, line)` for each word of the text of the element that begins here, and
    /// advances to its end. The text of elements inside of it is skipped.
    template <class Handle>
    void for_each_word(const Handle& handle);

    /// @throws BadFile `name:line: complaint`.
    [[noreturn]] void throw_bad_file(int line, const std::string& complaint) const;

   private:
    /// Removes the text up to and including `mark` from the rest; returns the text before `mark`.
    std::string_view take_until(std::string_view mark, const char* what);
    void read_attributes(std::string_view tag);
    Event begin(std::string_view tag);
    Event end(std::string_view tag);

    std::string name_;
    std::string_view rest_;
    int next_line_ = 1;
    int line_ = 1;
    std::string_view content_;
    int content_line_ = 1;
    std::string_view element_;
    bool ends_at_once_ = false;
    std::vector<std::string_view> open_;
    std::vector<std::pair<std::string_view, std::string_view>> attributes_;
};

template <class Handle>
void XmlScanner::for_each_word(const Handle& handle) {
    static constexpr CharSet kBlanks(" \t\r");
    static constexpr CharSet kWordEnds(" \t\r\n");
    int depth = 1;
    while (depth > 0) {
        const Event event = next();
        std::string_view rest = depth == 1 ? content_ : std::string_view();
        int line = content_line_;
        for (rest.remove_prefix(kBlanks.skip_in(rest)); !rest.empty();
             rest.remove_prefix(kBlanks.skip_in(rest))) {
            if (rest.front() == '\n') {
                ++line;
                rest.remove_prefix(1);
                continue;
            }
            const std::string_view word = rest.substr(0, kWordEnds.find_in(rest));
            handle(word, line);
            rest.remove_prefix(word.size());
        }
        depth += event == Event::kBegin ? 1 : -1;
    }
}

}  // namespace pcvt
