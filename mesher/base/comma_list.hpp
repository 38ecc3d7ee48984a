#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace pcvt {

/// The texts between the commas of a list; one empty text for an empty list.
///
///     between_commas("a,b")  // "a" and "b"
inline std::vector<std::string_view> between_commas(std::string_view list) {
    std::vector<std::string_view> texts;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        texts.push_back(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return texts;
}

}  // namespace pcvt
