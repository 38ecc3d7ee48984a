#pragma once

#include <vector>

#include "io/pictures/periodic_canvas.hpp"

namespace pcvt::testing {

/// The pixels of a periodic image moved by x to the right and y down.
inline std::vector<unsigned char> rolled(const RgbImage& image, int x, int y) {
    std::vector<unsigned char> rgb(image.rgb.size());
    for (int row = 0; row < image.height; ++row) {
        for (int k = 0; k < 3 * image.width; ++k) {
            const int to_row = (row + y) % image.height;
            const int to = (k + 3 * x) % (3 * image.width);
            rgb[to_row * 3 * image.width + to] = image.rgb[row * 3 * image.width + k];
        }
    }
    return rgb;
}

}  // namespace pcvt::testing
