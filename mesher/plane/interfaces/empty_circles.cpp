#include "mesher/plane/interfaces/empty_circles.hpp"

#include <algorithm>
#include <cmath>

namespace pcvt::plane {
namespace {

/// A site on a circle would merge its corner with the node.
constexpr double kEnlarged = 1.001;
constexpr double kMostSquares = 2048;

}  // namespace

EmptyCircles::EmptyCircles(const Lattice& reduced, std::span<const EmptyCircle> circles)
    : reduced_(reduced) {
    // The distances between the sides of the domain across u and across v.
    const std::array<double, 2> across{reduced.area() / reduced.b().norm(),
                                       reduced.area() / reduced.a().norm()};
    double mean = 0;
    for (const EmptyCircle& circle : circles) mean += circle.radius / double(circles.size());
    for (int k = 0; k < 2; ++k) {
        const double wanted = circles.empty() ? 1 : across[k] / (2 * mean);
        count_[k] = static_cast<int>(std::clamp(wanted, 1.0, kMostSquares));
    }
    // List the squares of each circle's bounding parallelogram, first to count, then to store.
    begin_.assign(static_cast<std::size_t>(count_[0]) * count_[1] + 1, 0);
    const auto for_each_square = [&](const auto& visit) {
        for (const EmptyCircle& circle : circles) {
            std::array<int, 2> first{};
            std::array<int, 2> last{};
            for (int k = 0; k < 2; ++k) {
                const double reach = kEnlarged * circle.radius / across[k];
                first[k] = static_cast<int>(std::floor((circle.centre[k] - reach) * count_[k]));
                last[k] = static_cast<int>(std::floor((circle.centre[k] + reach) * count_[k]));
            }
            for (int j = first[1]; j <= last[1]; ++j) {
                for (int i = first[0]; i <= last[0]; ++i) {
                    const double p = std::floor(double(i) / count_[0]);
                    const double q = std::floor(double(j) / count_[1]);
                    const int column = i - static_cast<int>(p) * count_[0];
                    const int row = j - static_cast<int>(q) * count_[1];
                    const std::size_t square = static_cast<std::size_t>(row) * count_[0] + column;
                    visit(square, Image{circle.centre - Vec2(p, q), kEnlarged * circle.radius});
                }
            }
        }
    };
    for_each_square([&](std::size_t square, const Image&) { ++begin_[square + 1]; });
    for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
    images_.resize(static_cast<std::size_t>(begin_.back()));
    std::vector<int> next(begin_.begin(), begin_.end() - 1);
    for_each_square(
        [&](std::size_t square, const Image& image) { images_[next[square]++] = image; });
}

bool EmptyCircles::contain(const Vec2& u) const {
    const Vec2 inside = u - Vec2(std::floor(u.x()), std::floor(u.y()));
    const int i = std::min(static_cast<int>(inside.x() * count_[0]), count_[0] - 1);
    const int j = std::min(static_cast<int>(inside.y() * count_[1]), count_[1] - 1);
    const std::size_t square = static_cast<std::size_t>(j) * count_[0] + i;
    for (int k = begin_[square]; k < begin_[square + 1]; ++k) {
        const Image& image = images_[k];
        const Vec2 d = reduced_.to_position(inside - image.centre);
        if (d.squaredNorm() < image.radius * image.radius) return true;
    }
    return false;
}

}  // namespace pcvt::plane
