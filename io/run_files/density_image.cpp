#include "io/run_files/density_image.hpp"

#include <algorithm>
#include <utility>

#include "io/bytes/input_file.hpp"
#include "mesher/plane/density/pixel_grid.hpp"

namespace pcvt {
plane::Density image_density(GreyImage image, const GreyRange& range) {
    // The lowest row comes first.
    for (int row = 0; row < image.height / 2; ++row) {
        float* const low = image.grey.data() + std::size_t(image.height - 1 - row) * image.width;
        float* const high = image.grey.data() + std::size_t(row) * image.width;
        std::swap_ranges(low, low + image.width, high);
    }
    return plane::pixel_density(
        {image.width, image.height, std::move(image.grey), range.black, range.white});
}

plane::Density png_density(const std::string& path, const GreyRange& range) {
    return image_density(decode_png(path, read_whole_file(path, kPictureInput)), range);
}

double png_height_over_width(const std::string& path) {
    const GreyImage image = decode_png(path, read_whole_file(path, kPictureInput));
    return double(image.height) / image.width;
}

}  // namespace pcvt
