#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bytes/bad_file.hpp"

namespace pcvt {

/// Walks over the tags of a plain XML text: elements with attributes and text, comments and
/// declarations passed over. No entities, no CDATA, no DTD: VTK's files need none.
class XmlScanner {
   public:
    enum class Event { kBegin, kEnd, kNothing };

    /// @param name  the file's name in messages.
    /// @param text  must outlive the scanner.
    XmlScanner(std::string name, std::string_view text);

    /// Steps to the next tag; an element without content, `<a/>`, begins and ends. kNothing after
    /// the last one.
    /// @throws BadFile with the line where the text is no XML, or tags do not nest.
    Event next();
    /// The element that begins or ends here.
    std::string_view element() const { return element_; }
    /// An attribute of the element that begins here.
    std::optional<std::string_view> attribute(std::string_view key) const;
    /// The text before the current tag, since the tag before, and the line on which it begins.
    std::string_view text() const { return content_; }
    int text_line() const { return content_line_; }
    /// The line of the current tag.
    int line() const { return line_; }
    const std::string& name() const { return name_; }

    /// @throws BadFile `name:line: complaint`.
    [[noreturn]] void throw_bad_file(int line, const std::string& complaint) const;

   private:
    /// Takes the text up to `mark` and the mark off; @returns the text.
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

}  // namespace pcvt
