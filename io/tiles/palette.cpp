#include "io/tiles/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcvt {
namespace {

constexpr int kFewest = 3;

constexpr Colour from_bytes(int red, int green, int blue) {
    return {red / 255.0, green / 255.0, blue / 255.0};
}

/// From three sides to nine, each way from pale to dark.
constexpr std::array<Colour, 7> kBySides{from_bytes(0x14, 0x21, 0x5c), from_bytes(0x25, 0x5f, 0xb0),
                                         from_bytes(0x62, 0xb0, 0xdf), from_bytes(0xf3, 0xef, 0xe4),
                                         from_bytes(0xf2, 0xa2, 0x3c), from_bytes(0xcb, 0x4b, 0x1e),
                                         from_bytes(0x70, 0x15, 0x18)};

/// From small to large, each lighter than the one before.
constexpr std::array<Colour, 5> kBySize{from_bytes(0x3a, 0x57, 0xa6), from_bytes(0x3f, 0x8c, 0xb8),
                                        from_bytes(0x67, 0xbb, 0xa6), from_bytes(0xb7, 0xdc, 0x9c),
                                        from_bytes(0xfb, 0xf3, 0xc4)};

/// The decoding curve of IEC 61966-2-1.
double linear_light(double component) {
    return component <= 0.04045 ? component / 12.92 : std::pow((component + 0.055) / 1.055, 2.4);
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

Colour size_colour(double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (kBySize.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), kBySize.size() - 2);
    const double part = place - static_cast<double>(below);
    const Colour& from = kBySize[below];
    const Colour& to = kBySize[below + 1];
    return {from.r + part * (to.r - from.r), from.g + part * (to.g - from.g),
            from.b + part * (to.b - from.b)};
}

Colour side_colour(int sides) {
    const int last = kFewest + static_cast<int>(kBySides.size()) - 1;
    return kBySides[static_cast<std::size_t>(std::clamp(sides, kFewest, last) - kFewest)];
}

}  // namespace pcvt
