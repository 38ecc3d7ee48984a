#include "io/run_files/density_image.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

/// More than the size of kMostPixels with 64 bits each, not compressed.
constexpr std::uintmax_t kMostBytes = 1U << 28;

/// The two pixels next to a coordinate, and the weight of the second one.
struct Between {
    int first;
    int second;
    double share;
};
Between between(double coordinate, int n) {
    // The centres lie at k + 1/2, the coordinate in [0, n].
    const double from_first = coordinate + 0.5;
    const int above = static_cast<int>(from_first);
    return {above == 0 ? n - 1 : above - 1, above >= n ? 0 : above, from_first - above};
}

double bilinear(const GreyImage& image, double u, double v) {
    const Between x = between(u * image.width, image.width);
    const Between y = between((1 - v) * image.height, image.height);
    const float* first = image.grey.data() + std::size_t(y.first) * image.width;
    const float* second = image.grey.data() + std::size_t(y.second) * image.width;
    const double upper = first[x.first] + x.share * (first[x.second] - first[x.first]);
    const double lower = second[x.first] + x.share * (second[x.second] - second[x.first]);
    return upper + y.share * (lower - upper);
}

std::vector<double> centres(int n) {
    std::vector<double> coordinates;
    for (int k = 0; k < n; ++k) coordinates.push_back((k + 0.5) / n);
    return coordinates;
}

}  // namespace

Density image_density(GreyImage image, const GreyRange& range) {
    const auto shared = std::make_shared<const GreyImage>(std::move(image));
    const auto function = [shared, range](const DensityPoint& point) {
        return range.black + (range.white - range.black) * bilinear(*shared, point.u, point.v);
    };
    Density density = shared_density(function);
    density.u_breaks = centres(shared->width);
    density.v_breaks = centres(shared->height);
    return density;
}

Density png_density(const std::string& path, const GreyRange& range) {
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(path, unknown);
    if (!unknown && size > kMostBytes) {
        throw LimitExceeded(path + ": more than 256 MiB; scale the image down");
    }
    return image_density(decode_png(path, read_whole_file(path)), range);
}

}  // namespace pcvt
