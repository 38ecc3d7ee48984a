#include "io/bytes/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "io/bytes/char_set.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kDigitsAndPadding =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
constexpr std::string_view kDigits = kDigitsAndPadding.substr(0, 64);
constexpr CharSet kText(kDigitsAndPadding);

/// The value of each character as a base64 digit; -1 for all other characters.
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
    const auto append = [&](std::uint32_t group, int n_digits) {
        for (int l = 0; l < n_digits; ++l) digit[l] = kDigits[group >> (18 - 6 * l) & 63];
        digit += 4;
    };
    const std::size_t n_whole = bytes.size() / 3 * 3;
    for (std::size_t k = 0; k < n_whole; k += 3) {
        checkpoint_each(k);
        append(std::uint32_t{bytes[k]} << 16 | std::uint32_t{bytes[k + 1]} << 8 | bytes[k + 2], 4);
    }
    if (bytes.size() == n_whole + 1) append(std::uint32_t{bytes[n_whole]} << 16, 2);
    if (bytes.size() == n_whole + 2) {
        append(std::uint32_t{bytes[n_whole]} << 16 | std::uint32_t{bytes[n_whole + 1]} << 8, 3);
    }
}

std::size_t base64_length(std::string_view text) { return kText.skip_in(text); }

bool decode_base64(std::string_view text, std::string& bytes) {
    // At most two characters of padding.
    if (text.size() % 4 != 0) return false;
    std::size_t padding = 0;
    while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=')
        ++padding;
    static constexpr std::array<signed char, 256> kValues = base64_values();
    bytes.resize(text.size() / 4 * 3);
    char* byte = bytes.data();
    // Four digits become three bytes. `all` is negative from the first invalid digit on.
    int all = 0;
    const auto append = [&](const char* digits, std::size_t n_digits) {
        int group = 0;
        for (std::size_t l = 0; l < 4; ++l) {
            const int digit = l < n_digits ? kValues[static_cast<unsigned char>(digits[l])] : 0;
            all |= digit;
            group = group << 6 | (digit & 63);
        }
        for (const int shift : {16, 8, 0}) *byte++ = static_cast<char>(group >> shift & 0xff);
    };
    // The last group may be padded.
    const std::size_t n_whole = text.size() - (padding > 0 ? 4 : 0);
    for (std::size_t k = 0; k < n_whole; k += 4) {
        checkpoint_each(long(k));
        append(text.data() + k, 4);
    }
    if (padding > 0) append(text.data() + n_whole, 4 - padding);
    bytes.resize(bytes.size() - padding);
    return all >= 0;
}

}  // namespace pcvt
