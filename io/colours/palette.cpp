#include "io/colours/palette.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "mesher/portable/portable_functions.hpp"

namespace pcvt {
namespace {

constexpr int kFewest = 3;

constexpr Colour from_bytes(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    return {red / 255.0, green / 255.0, blue / 255.0};
}

/// The colours of cells with three to nine sides, from pale at six to dark at both ends.
constexpr std::array<Colour, 7> kBySides{from_bytes(0x14, 0x21, 0x5c), from_bytes(0x25, 0x5f, 0xb0),
                                         from_bytes(0x62, 0xb0, 0xdf), from_bytes(0xf3, 0xef, 0xe4),
                                         from_bytes(0xf2, 0xa2, 0x3c), from_bytes(0xcb, 0x4b, 0x1e),
                                         from_bytes(0x70, 0x15, 0x18)};

/// The colours of values from small to large, each lighter than the one before.
constexpr std::array<Colour, kValueClasses> kByValue{
    from_bytes(0x3a, 0x57, 0xa6), from_bytes(0x40, 0x86, 0xb7), from_bytes(0x5f, 0xb3, 0xb0),
    from_bytes(0x98, 0xcb, 0x90), from_bytes(0xd7, 0xe8, 0x94), from_bytes(0xff, 0xf9, 0xd6)};

/// Light enough for dark lines and dots.
constexpr std::array<Colour, kCellColours> kByCell{
    from_bytes(0x93, 0xe9, 0xf4), from_bytes(0xf7, 0xd6, 0x89), from_bytes(0xb9, 0xdc, 0xa5),
    from_bytes(0xd5, 0x90, 0x8a), from_bytes(0xc5, 0xad, 0xed), from_bytes(0xf3, 0xef, 0xe4),
    from_bytes(0x80, 0xc5, 0xbd)};

constexpr std::array<Colour, kSeamColours> kSeams{
    from_bytes(0x07, 0x79, 0x74), from_bytes(0x81, 0x2e, 0xd1), from_bytes(0x97, 0x59, 0x44),
    from_bytes(0x0d, 0x93, 0xe2), from_bytes(0x79, 0x99, 0x46), from_bytes(0xdb, 0x18, 0x79)};

/// The decoding curve of IEC 61966-2-1.
double linear_light(double component) {
    return component <= 0.04045 ? component / 12.92
                                : portable_exp(2.4 * portable_log((component + 0.055) / 1.055));
}

}  // namespace

Colour linear(Colour srgb) {
    return {linear_light(srgb.r), linear_light(srgb.g), linear_light(srgb.b)};
}

std::string hex(Colour colour) {
    std::string text = "#";
    for (const double component : {colour.r, colour.g, colour.b}) {
        const long byte = std::lround(255 * std::clamp(component, 0.0, 1.0));
        text += "0123456789abcdef"[byte / 16];
        text += "0123456789abcdef"[byte % 16];
    }
    return text;
}

Colour value_colour(double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (kByValue.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), kByValue.size() - 2);
    const double part = place - static_cast<double>(below);
    const Colour& from = kByValue[below];
    const Colour& to = kByValue[below + 1];
    return {from.r + part * (to.r - from.r), from.g + part * (to.g - from.g),
            from.b + part * (to.b - from.b)};
}

Colour side_colour(int sides) {
    const int last = kFewest + static_cast<int>(kBySides.size()) - 1;
    return kBySides[static_cast<std::size_t>(std::clamp(sides, kFewest, last) - kFewest)];
}

Colour cell_colour(int k) { return kByCell[static_cast<std::size_t>(k)]; }

Colour seam_colour(std::size_t k) { return kSeams[k % kSeams.size()]; }

double luminance(Colour srgb) {
    const Colour light = linear(srgb);
    return 0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b;
}

std::optional<Colour> colour_of_hex(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(text.begin() + 1, text.end(), number, 16);
    if (error != std::errc() || end != text.end()) return std::nullopt;
    return from_bytes(number >> 16, number >> 8 & 0xFF, number & 0xFF);
}

}  // namespace pcvt
