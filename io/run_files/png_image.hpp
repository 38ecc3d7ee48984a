#pragma once

#include <string>
#include <vector>

namespace pcvt {

/// A grey picture: row 0 is the uppermost, values from 0, black, to 1, white.
struct GreyImage {
    int width;
    int height;
    std::vector<float> grey;
};

/// Larger pictures are refused before memory is taken for them.
inline constexpr int kMostPixels = 1 << 24;

/// Decodes a PNG of any colour type, 1 to 16 bits deep, plain or interlaced.
///
/// Samples count as they stand in the file, over their largest value: gAMA, sRGB and iCCP are not
/// looked at. Colours become 0.2126 R + 0.7152 G + 0.0722 B. What is transparent shows white paper.
/// @param name  of the file, for the messages.
/// @throws BadFile `name: what; what to do` where the bytes are no PNG, are truncated or damaged,
/// or
///         have no palette where one is needed.
/// @throws LimitExceeded for more than kMostPixels.
GreyImage decode_png(const std::string& name, const std::string& bytes);

}  // namespace pcvt
