#include "mesher/plane/density/pixel_grid.hpp"

#include <algorithm>
#include <utility>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// Rows of a block: its sums take 1.5 bytes a pixel.
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
    if (number >= 0 && number < n) return static_cast<int>(number);
    const auto rest = static_cast<int>(number % n);
    return rest < 0 ? rest + n : rest;
}

/// Sums over the pixels of a line, which are bilinear hats: the first and the last one count from
/// their centres on.
class LineSum {
   public:
    explicit LineSum(double first) : mass_(first / 2), t_(first / 6), tt_(first / 12) {}
    /// A pixel at t between both ends.
    void add(double rho, double t) {
        mass_ += rho;
        t_ += rho * t;
        tt_ += rho * (t * t + 1.0 / 6);
    }
    /// The pixel at the end t.
    LineMoments end(double rho, double t) const {
        return {mass_ + rho * (1.0 / 2), t_ + rho * ((3 * t - 1) * (1.0 / 6)),
                tt_ + rho * ((t * (6 * t - 4) + 1) * (1.0 / 12))};
    }

   private:
    double mass_;
    double t_;
    double tt_;
};

std::vector<double> centres(int n) {
    std::vector<double> coordinates;
    coordinates.reserve(n);
    for (int k = 0; k < n; ++k) coordinates.push_back((k + 0.5) / n);
    return coordinates;
}

}  // namespace

void LineMoments::add(const LineMoments& other, double up) {
    mass += other.mass;
    t += other.t + up * other.mass;
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
    for (int row = 0; row < height_; row += kBlock) {
        checkpoint();
        LineMoments* const sums = blocks_.data() + std::size_t(row / kBlock) * width_;
        for (int column = 0; column < width_; ++column) {
            sums[column] = short_run(column, row, std::min(row + kBlock, height_)).left;
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

PixelGrid::Square PixelGrid::square(std::int64_t column, std::int64_t row) const {
    const int left = wrapped(column, width_);
    const int right = left + 1 == width_ ? 0 : left + 1;
    const int at_row = wrapped(row, height_);
    const float* const low = line(at_row);
    const float* const high = line(at_row + 1 == height_ ? 0 : at_row + 1);
    return {value(low[left]), value(low[right]), value(high[left]), value(high[right])};
}

/// A run of at least one row, inside of the picture, by its pixels.
PixelGrid::Run PixelGrid::short_run(int left, int row, int end) const {
    const int right = left + 1 == width_ ? 0 : left + 1;
    LineSum left_sum(value(line(row)[left]));
    LineSum right_sum(value(line(row)[right]));
    for (int at = row + 1; at < end; ++at) {
        left_sum.add(value(line(at)[left]), at - row);
        right_sum.add(value(line(at)[right]), at - row);
    }
    const float* const last = line(end == height_ ? 0 : end);
    return {left_sum.end(value(last[left]), end - row),
            right_sum.end(value(last[right]), end - row)};
}

PixelGrid::Run PixelGrid::run(std::int64_t column, std::int64_t row, std::int64_t end) const {
    const int left = wrapped(column, width_);
    const int right = left + 1 == width_ ? 0 : left + 1;
    int at_row = wrapped(row, height_);
    Run sum;
    for (std::int64_t done = 0; done < end - row;) {
        // Add the rest of the block, or a part of it.
        const int block_end = std::min((at_row / kBlock + 1) * kBlock, height_);
        const auto n =
            static_cast<int>(std::min<std::int64_t>(block_end - at_row, end - row - done));
        if (at_row % kBlock == 0 && at_row + n == block_end) {
            const LineMoments* const block = blocks_.data() + std::size_t(at_row / kBlock) * width_;
            sum.left.add(block[left], double(done));
            sum.right.add(block[right], double(done));
        } else {
            const Run part = short_run(left, at_row, at_row + n);
            sum.left.add(part.left, double(done));
            sum.right.add(part.right, double(done));
        }
        done += n;
        at_row = at_row + n == height_ ? 0 : at_row + n;
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
