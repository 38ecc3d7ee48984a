#include "tests/mutants/xml_namer.hpp"

namespace pcvt::testing {
namespace {

bool is_number(std::string_view word) {
    return word[0] == '-' || (word[0] >= '0' && word[0] <= '9');
}

/// Whether the word is the key of an attribute: `=` follows it.
/// @pre it is not the last one of its tag, which ends with `>`.
bool is_key(std::string_view word) { return word.data()[word.size()] == '='; }

}  // namespace

LineNames XmlNamer::operator()(const std::vector<std::string_view>& words) {
    if (words.empty() || words[0].starts_with('?') || words[0].starts_with('!')) return {};
    if (is_binary_) {
        is_binary_ = false;
        return {};
    }
    if (!is_number(words[0])) return names_of_tag(words);
    LineNames names{.row = array_ + " row"};
    for (std::size_t w = 0; w < words.size(); ++w) names.words.push_back(array_ + " value");
    return names;
}

/// The words of a tag are its element, and the names and the values of its attributes.
LineNames XmlNamer::names_of_tag(const std::vector<std::string_view>& words) {
    for (std::size_t w = 0; w + 1 < words.size(); ++w) {
        if (words[w] == "Name") array_ = std::string(words[w + 1]);
        is_binary_ = is_binary_ || (words[w] == "format" && words[w + 1] == "binary");
    }
    const std::string tag = words[0] == "DataArray" ? array_ : std::string(words[0]);
    LineNames names{.row = "", .words = {tag + " tag"}};
    std::string key;
    for (std::size_t w = 1; w < words.size(); ++w) {
        if (is_key(words[w])) {
            key = tag + " " + std::string(words[w]);
            names.words.push_back(key + " key");
        } else {
            names.words.push_back(key);
        }
    }
    return names;
}

}  // namespace pcvt::testing
