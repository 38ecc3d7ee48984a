#pragma once

#include <string>
#include <vector>

namespace pcvt {

/// A grey image. Row 0 is the top row; values range from 0 for black to 1 for white.
struct GreyImage {
    int width;
    int height;
    std::vector<float> grey;
};

/// Larger images are refused before memory is allocated for them.
inline constexpr int kMostPixels = 1 << 24;
inline constexpr int kLongestSide = 1 << 14;

/// Decodes a PNG of any colour type, 1 to 16 bits deep, plain or interlaced.
///
/// A sample of the file is divided by the largest sample of its depth; gAMA, sRGB and iCCP are
/// ignored. Colours become 0.2126 R + 0.7152 G + 0.0722 B. Transparent pixels show a white
/// background.
///
/// Example usage:
///     const GreyImage image = decode_png("spacing.png", read_whole_file("spacing.png"));
///     const float top_left = image.grey.front();
///
/// @param name  the file's name in messages.
/// @throws BadFile `name: problem; remedy` if the bytes are not a PNG, are truncated or damaged, or
///         lack a palette that the image needs.
/// @throws LimitExceeded for more than kMostPixels, or more than kLongestSide along a side.
GreyImage decode_png(const std::string& name, const std::string& bytes);

}  // namespace pcvt
