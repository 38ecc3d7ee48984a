#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace pcvt {

/// A set of characters, looked up in a table: scanners of large files ask it for each character.
class CharSet {
   public:
    constexpr explicit CharSet(std::string_view members) {
        for (const char c : members) holds_[static_cast<unsigned char>(c)] = true;
    }

    constexpr bool holds(char c) const { return holds_[static_cast<unsigned char>(c)]; }
    /// Where the first member stands, and the first character that is none; the size of `text`
    /// where there is none.
    constexpr std::size_t find_in(std::string_view text) const {
        std::size_t k = 0;
        while (k < text.size() && !holds(text[k])) ++k;
        return k;
    }
    constexpr std::size_t skip_in(std::string_view text) const {
        std::size_t k = 0;
        while (k < text.size() && holds(text[k])) ++k;
        return k;
    }

   private:
    std::array<bool, 256> holds_{};
};

}  // namespace pcvt
