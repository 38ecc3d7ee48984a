#include "io/bytes/xml_scanner.hpp"

#include <algorithm>

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kXmlBlanks = " \t\r\n";

std::string_view without_blanks_before(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kXmlBlanks), text.size()));
    return text;
}

}  // namespace

XmlScanner::XmlScanner(std::string name, std::string_view text)
    : name_(std::move(name)), rest_(text) {}

void XmlScanner::throw_bad_file(int line, const std::string& complaint) const {
    throw BadFile(name_ + ":" + std::to_string(line) + ": " + complaint);
}

std::string_view XmlScanner::take_until(std::string_view mark, const char* what) {
    const std::size_t length = rest_.find(mark);
    if (length == std::string_view::npos) {
        throw_bad_file(next_line_, std::string(what) + " does not end; give the whole file");
    }
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length + mark.size());
    next_line_ += static_cast<int>(std::count(taken.begin(), taken.end(), '\n'));
    return taken;
}

XmlScanner::Event XmlScanner::next() {
    // An element without content ends where it begins.
    if (ends_at_once_) {
        ends_at_once_ = false;
        content_ = {};
        return Event::kEnd;
    }
    while (true) {
        // At the end of the text, every element must be closed.
        content_line_ = next_line_;
        if (without_blanks_before(rest_).empty()) {
            if (!open_.empty()) {
                throw_bad_file(next_line_,
                               in_quotes(open_.back()) + " does not end; give the whole file");
            }
            return Event::kNothing;
        }
        // Return the next tag; skip comments and declarations.
        content_ = take_until("<", "the text");
        line_ = next_line_;
        if (rest_.starts_with("!--")) {
            if (!without_blanks_before(content_).empty()) {
                throw_bad_file(line_, "a comment interrupts a text; remove it");
            }
            take_until("-->", "a comment");
        } else if (rest_.starts_with("?")) {
            take_until("?>", "a declaration");
        } else {
            const std::string_view tag = take_until(">", "a tag");
            return tag.starts_with("/") ? end(tag.substr(1)) : begin(tag);
        }
    }
}

XmlScanner::Event XmlScanner::begin(std::string_view tag) {
    ends_at_once_ = tag.ends_with("/");
    if (ends_at_once_) tag.remove_suffix(1);
    const std::size_t length = std::min(tag.find_first_of(kXmlBlanks), tag.size());
    element_ = tag.substr(0, length);
    if (element_.empty()) throw_bad_file(line_, "a tag has no name; give an XML file");
    read_attributes(tag.substr(length));
    if (!ends_at_once_) open_.push_back(element_);
    return Event::kBegin;
}

XmlScanner::Event XmlScanner::end(std::string_view tag) {
    element_ = tag.substr(0, std::min(tag.find_first_of(kXmlBlanks), tag.size()));
    if (open_.empty() || open_.back() != element_) {
        throw_bad_file(line_, in_quotes(element_) + " ends, but is not open; give the whole file");
    }
    open_.pop_back();
    return Event::kEnd;
}

void XmlScanner::read_attributes(std::string_view tag) {
    attributes_.clear();
    for (tag = without_blanks_before(tag); !tag.empty(); tag = without_blanks_before(tag)) {
        const std::size_t equals = tag.find('=');
        const char quote = equals + 1 < tag.size() ? tag[equals + 1] : '\0';
        const bool begins = equals != std::string_view::npos && (quote == '"' || quote == '\'') &&
                            tag.substr(0, equals).find_first_of(" \t\r\n<") == tag.npos;
        const std::size_t stop = begins ? tag.find(quote, equals + 2) : std::string_view::npos;
        if (stop == std::string_view::npos) {
            throw_bad_file(line_, "an attribute of " + in_quotes(element_) +
                                      " is not of the form key=\"value\"; correct it");
        }
        attributes_.emplace_back(tag.substr(0, equals), tag.substr(equals + 2, stop - equals - 2));
        tag.remove_prefix(stop + 1);
    }
}

std::optional<std::string_view> XmlScanner::attribute(std::string_view key) const {
    for (const auto& [name, value] : attributes_) {
        if (name == key) return value;
    }
    return std::nullopt;
}

}  // namespace pcvt
