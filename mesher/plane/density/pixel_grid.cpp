#include "mesher/plane/density/pixel_grid.hpp"

#include <algorithm>
#include <utility>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// Rows of a block: its sums take 3 bytes a pixel.
constexpr int kBlock = 16;

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

double mixed(double first, double second, double share) { return first + share * (second - first); }

int wrapped(std::int64_t number, int n) {
    const auto rest = static_cast<int>(number % n);
    return rest < 0 ? rest + n : rest;
}

/// The moments of the bilinear function with these values at the corners of the unit square.
PlainMoments square_moments(const PixelGrid::Square& f) {
    const double left = f.low_left + f.high_left;
    const double right = f.low_right + f.high_right;
    const double low = f.low_left + f.low_right;
    const double high = f.high_left + f.high_right;
    return {.mass = (left + right) / 4,
            .s = (left + 2 * right) / 12,
            .t = (low + 2 * high) / 12,
            .ss = (left + 3 * right) / 24,
            .st = (f.low_left + 2 * (f.low_right + f.high_left) + 4 * f.high_right) / 36,
            .tt = (low + 3 * high) / 24};
}

std::vector<double> centres(int n) {
    std::vector<double> coordinates;
    coordinates.reserve(n);
    for (int k = 0; k < n; ++k) coordinates.push_back((k + 0.5) / n);
    return coordinates;
}

}  // namespace

void PlainMoments::add(const PlainMoments& other, double up) {
    mass += other.mass;
    s += other.s;
    ss += other.ss;
    t += other.t + up * other.mass;
    st += other.st + up * other.s;
    tt += other.tt + up * (2 * other.t + up * other.mass);
}

PixelGrid::PixelGrid(int width, int height, std::vector<float> greys, double black, double white)
    : width_(width),
      height_(height),
      greys_(std::move(greys)),
      black_(black),
      white_(white),
      blocks_(std::size_t(width) * ((height + kBlock - 1) / kBlock)) {
    survey();
    fill_blocks();
}

void PixelGrid::survey() {
    const auto [least, greatest] = std::minmax_element(greys_.begin(), greys_.end());
    const double one = value(*least);
    const double other = value(*greatest);
    range_.least = std::min(one, other);
    range_.greatest = std::max(one, other);
    // Rows first, so that the rounding error stays small.
    for (int row = 0; row < height_; ++row) {
        checkpoint();
        double sum = 0;
        for (int column = 0; column < width_; ++column) sum += value(line(row)[column]);
        mean_ += sum;
    }
    mean_ /= double(width_) * height_;
}

void PixelGrid::fill_blocks() {
    for (int row = 0; row < height_; ++row) {
        checkpoint();
        PlainMoments* const sums = blocks_.data() + std::size_t(row / kBlock) * width_;
        for (int column = 0; column < width_; ++column) {
            sums[column].add(square_moments(inner_square(column, row)), row % kBlock);
        }
    }
}

double PixelGrid::at(double u, double v) const {
    const Between x = between(u * width_, width_);
    // Counted from the top row.
    const Between y = between((1 - v) * height_, height_);
    const float* const upper = line(height_ - 1 - y.first);
    const float* const lower = line(height_ - 1 - y.second);
    const double high = mixed(upper[x.first], upper[x.second], x.share);
    const double low = mixed(lower[x.first], lower[x.second], x.share);
    return black_ + (white_ - black_) * mixed(high, low, y.share);
}

PixelGrid::Square PixelGrid::inner_square(int column, int row) const {
    const int right = column + 1 == width_ ? 0 : column + 1;
    const float* const low = line(row);
    const float* const high = line(row + 1 == height_ ? 0 : row + 1);
    return {value(low[column]), value(low[right]), value(high[column]), value(high[right])};
}

PixelGrid::Square PixelGrid::square(std::int64_t column, std::int64_t row) const {
    return inner_square(wrapped(column, width_), wrapped(row, height_));
}

PlainMoments PixelGrid::run(std::int64_t column, std::int64_t row, std::int64_t end) const {
    const int at_column = wrapped(column, width_);
    int at_row = wrapped(row, height_);
    PlainMoments sum;
    for (std::int64_t done = 0; done < end - row;) {
        const int block_end = std::min((at_row / kBlock + 1) * kBlock, height_);
        if (at_row % kBlock == 0 && done + block_end - at_row <= end - row) {
            sum.add(blocks_[std::size_t(at_row / kBlock) * width_ + at_column], double(done));
            done += block_end - at_row;
            at_row = block_end == height_ ? 0 : block_end;
            continue;
        }
        sum.add(square_moments(inner_square(at_column, at_row)), double(done++));
        at_row = at_row + 1 == height_ ? 0 : at_row + 1;
    }
    return sum;
}

Density pixel_density(PixelGrid grid) {
    const auto shared = std::make_shared<const PixelGrid>(std::move(grid));
    Density density =
        shared_density([shared](const DensityPoint& p) { return shared->at(p.u, p.v); });
    density.u_breaks = centres(shared->width());
    density.v_breaks = centres(shared->height());
    density.pixels = shared;
    return density;
}

}  // namespace pcvt::plane
