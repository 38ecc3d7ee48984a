#include "io/pictures/periodic_canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// Samples along each side of a pixel.
constexpr int kSamples = 4;
constexpr PackedColour kUncovered = 0xffffffff;
constexpr PackedColour kWhite = 0xffffff;

int wrapped(std::int64_t k, int period) {
    const auto rest = static_cast<int>(k % period);
    return rest < 0 ? rest + period : rest;
}

/// Returns the first sample at or after a position in pixels; sample k lies at (k + 1/2) / 4.
std::int64_t first_sample(double position) {
    return static_cast<std::int64_t>(std::ceil(kSamples * position - 0.5));
}

/// Finds where the horizontal line at y enters and leaves a polygon.
void find_crossings(std::span<const plane::Vec2> corners, double y,
                    std::vector<double>& crossings) {
    plane::Vec2 from = corners.back();
    for (const plane::Vec2& to : corners) {
        // Both faces at an edge compute its crossing from its lower end.
        const auto& [low, high] = std::minmax(
            from, to, [](const plane::Vec2& p, const plane::Vec2& q) { return p.y() < q.y(); });
        if (low.y() <= y && y < high.y()) {
            const double part = (y - low.y()) / (high.y() - low.y());
            crossings.push_back(low.x() + part * (high.x() - low.x()));
        }
        from = to;
    }
    std::sort(crossings.begin(), crossings.end());
}

/// Finds where the horizontal line at y enters and leaves a stroke, the hull of two discs.
void find_crossings(const plane::Vec2& from, const plane::Vec2& to, double radius, double y,
                    std::vector<double>& crossings) {
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    const auto include = [&](double x) {
        left = std::min(left, x);
        right = std::max(right, x);
    };
    // The discs.
    for (const plane::Vec2& centre : {from, to}) {
        const double square = radius * radius - (y - centre.y()) * (y - centre.y());
        if (square < 0) continue;
        include(centre.x() - std::sqrt(square));
        include(centre.x() + std::sqrt(square));
    }
    // The two sides of the line.
    const plane::Vec2 along = to - from;
    const double length = along.norm();
    if (length > 0) {
        const plane::Vec2 across = radius / length * plane::Vec2(-along.y(), along.x());
        for (const plane::Vec2& side : {across, plane::Vec2(-across)}) {
            const double part = (y - from.y() - side.y()) / along.y();
            if (part >= 0 && part <= 1) include(from.x() + side.x() + part * along.x());
        }
    }
    if (left < right) crossings = {left, right};
}

void fill_gaps(std::span<PackedColour> samples) {
    const auto covered = std::find_if(samples.begin(), samples.end(),
                                      [](PackedColour colour) { return colour != kUncovered; });
    if (covered == samples.end()) {
        std::fill(samples.begin(), samples.end(), kWhite);
        return;
    }
    // The sample to the left of the first one is the last one.
    const auto begin = static_cast<std::size_t>(covered - samples.begin());
    PackedColour left = *covered;
    for (std::size_t k = 1; k <= samples.size(); ++k) {
        PackedColour& colour = samples[(begin + k) % samples.size()];
        if (colour == kUncovered) colour = left;
        left = colour;
    }
}

/// Appends the mean colour of each pixel of a row.
void append_means(std::span<const PackedColour> samples, std::vector<unsigned char>& rgb) {
    const std::size_t n = samples.size() / kSamples;
    for (std::size_t x = 0; x < n; x += kSamples) {
        std::array<unsigned, 3> sums{};
        for (std::size_t row = 0; row < kSamples; ++row) {
            for (const PackedColour colour : samples.subspan(row * n + x, kSamples)) {
                sums[0] += colour >> 16 & 0xff;
                sums[1] += colour >> 8 & 0xff;
                sums[2] += colour & 0xff;
            }
        }
        constexpr unsigned kCount = kSamples * kSamples;
        for (const unsigned sum : sums) {
            rgb.push_back(static_cast<unsigned char>((sum + kCount / 2) / kCount));
        }
    }
}

}  // namespace

PackedColour packed(Colour colour) {
    return static_cast<PackedColour>(std::stoul(hex(colour).substr(1), nullptr, 16));
}

PeriodicCanvas::PeriodicCanvas(int width, int height, Walls walls)
    : width_(width), height_(height), walls_(walls) {}

void PeriodicCanvas::add_polygon(std::span<const plane::Vec2> corners, PackedColour colour) {
    shapes_.push_back({corners_.size(), corners.size(), -1, colour});
    corners_.insert(corners_.end(), corners.begin(), corners.end());
}

void PeriodicCanvas::add_stroke(const plane::Vec2& from, const plane::Vec2& to, double width,
                                PackedColour colour) {
    shapes_.push_back({corners_.size(), 2, width / 2, colour});
    corners_.push_back(from);
    corners_.push_back(to);
}

/// Paints the samples of one line.
/// @param y  of the line, in the copy of the canvas where the shape lies.
void PeriodicCanvas::paint_row(const Shape& shape, double y, std::span<PackedColour> samples,
                               std::vector<double>& crossings) const {
    crossings.clear();
    const std::span corners = std::span(corners_).subspan(shape.first_corner, shape.n_corners);
    if (shape.radius < 0) {
        find_crossings(corners, y, crossings);
    } else {
        find_crossings(corners[0], corners[1], shape.radius, y, crossings);
    }
    const int n = kSamples * width_;
    const bool has_walls = has_walls_across(walls_, 0);
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
        std::int64_t begin = first_sample(crossings[k]);
        if (has_walls) begin = std::max<std::int64_t>(begin, 0);
        const std::int64_t most = has_walls ? n : begin + n;
        const std::int64_t end = std::min(first_sample(crossings[k + 1]), most);
        int at = wrapped(begin, n);
        for (std::int64_t left = end - begin; left > 0; --left) {
            samples[at] = shape.colour;
            if (++at == n) at = 0;
        }
    }
}

/// Lists the shapes that touch each row of pixels, in their order.
std::vector<std::vector<PeriodicCanvas::Touch>> PeriodicCanvas::touches() const {
    std::vector<std::vector<Touch>> rows(static_cast<std::size_t>(height_));
    for (std::size_t s = 0; s < shapes_.size(); ++s) {
        const std::span corners =
            std::span(corners_).subspan(shapes_[s].first_corner, shapes_[s].n_corners);
        const auto [low, high] = std::minmax_element(
            corners.begin(), corners.end(),
            [](const plane::Vec2& p, const plane::Vec2& q) { return p.y() < q.y(); });
        const double reach = std::max(shapes_[s].radius, 0.0);
        const auto last = static_cast<std::int64_t>(std::floor(high->y() + reach));
        for (auto row = static_cast<std::int64_t>(std::floor(low->y() - reach)); row <= last;
             ++row) {
            const int place = wrapped(row, height_);
            const auto period = static_cast<int>((row - place) / height_);
            if (has_walls_across(walls_, 1) && period != 0) continue;
            rows[place].push_back({static_cast<int>(s), period});
        }
    }
    return rows;
}

RgbImage PeriodicCanvas::render() const {
    const std::vector<std::vector<Touch>> rows = touches();
    // Paint row after row.
    RgbImage image{width_, height_, {}};
    image.rgb.reserve(std::size_t{3} * width_ * height_);
    const std::size_t n = std::size_t{kSamples} * width_;
    std::vector<PackedColour> samples(kSamples * n);
    std::vector<double> crossings;
    for (int row = 0; row < height_; ++row) {
        checkpoint();
        std::fill(samples.begin(), samples.end(), kUncovered);
        for (std::size_t line = 0; line < kSamples; ++line) {
            const std::span painted = std::span(samples).subspan(line * n, n);
            const double depth = (static_cast<double>(line) + 0.5) / kSamples;
            for (const auto& [shape, period] : rows[row]) {
                const double y = static_cast<double>(period) * height_ + row + depth;
                paint_row(shapes_[shape], y, painted, crossings);
            }
            fill_gaps(painted);
        }
        append_means(samples, image.rgb);
    }
    return image;
}

}  // namespace pcvt
