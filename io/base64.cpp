#include "io/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "io/char_set.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kDigitsAndPadding =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
constexpr std::string_view kDigits = kDigitsAndPadding.substr(0, 64);
constexpr CharSet kText(kDigitsAndPadding);

/// The value of each character as a base64 digit; -1 for the others.
constexpr std::array<signed char, 256> base64_values() {
    std::array<signed char, 256> values{};
    for (signed char& value : values) value = -1;
    for (std::size_t k = 0; k < kDigits.size(); ++k) {
        values[static_cast<unsigned char>(kDigits[k])] = static_cast<signed char>(k);
    }
    return values;
}

}  // namespace

void append_base64(std::string& text, const std::vector<unsigned char>& bytes) {
    const std::size_t head = text.size();
    text.resize(head + (bytes.size() + 2) / 3 * 4, '=');
    char* digit = text.data() + head;
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - k);
        std::uint32_t group = 0;
        for (std::size_t l = 0; l < 3; ++l) group = group << 8 | (l < n ? bytes[k + l] : 0U);
        for (std::size_t l = 0; l <= n; ++l) digit[l] = kDigits[group >> (18 - 6 * l) & 63];
        digit += 4;
    }
}

std::size_t base64_length(std::string_view text) { return kText.skip_in(text); }

bool decode_base64(std::string_view text, std::string& bytes) {
    if (text.size() % 4 != 0) return false;
    std::size_t padding = 0;
    while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=')
        ++padding;
    static constexpr std::array<signed char, 256> kValues = base64_values();
    bytes.resize(text.size() / 4 * 3);
    char* byte = bytes.data();
    for (std::size_t k = 0; k < text.size(); k += 4) {
        int group = 0;
        for (std::size_t l = k; l < k + 4; ++l) {
            const int digit =
                l + padding < text.size() ? kValues[static_cast<unsigned char>(text[l])] : 0;
            if (digit < 0) return false;
            group = group << 6 | digit;
        }
        for (const int shift : {16, 8, 0}) *byte++ = static_cast<char>(group >> shift & 0xff);
    }
    bytes.resize(bytes.size() - padding);
    return true;
}

}  // namespace pcvt
