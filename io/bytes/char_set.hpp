#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace pcvt {

/// A set of characters, stored as a table because scanners of large files test every character.
///
/// Example usage:
///     constexpr CharSet kBlanks(" \t");
///     text.remove_prefix(kBlanks.skip_in(text));
///     const std::string_view word = text.substr(0, kBlanks.find_in(text));
class CharSet {
   public:
    constexpr explicit CharSet(std::string_view members) {
        for (const char c : members) holds_[static_cast<unsigned char>(c)] = true;
    }

    constexpr bool holds(char c) const { return holds_[static_cast<unsigned char>(c)]; }
    /// Returns the index of the first character of `text` in the set; text.size() if there is none.
    constexpr std::size_t find_in(std::string_view text) const {
        std::size_t k = 0;
        while (k < text.size() && !holds(text[k])) ++k;
        return k;
    }
    /// Returns the index of the first character of `text` outside of the set; text.size() if there
    /// is none.
    constexpr std::size_t skip_in(std::string_view text) const {
        std::size_t k = 0;
        while (k < text.size() && holds(text[k])) ++k;
        return k;
    }

   private:
    std::array<bool, 256> holds_{};
};

}  // namespace pcvt
