#include "mesher/plane/density/pixel_quadrature.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/target_clones.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {
namespace {

/// Gauss-Legendre points on a segment: exact for polynomials of degree 5, such as the density times
/// squares of coordinates, integrated along y.
constexpr int kPoints = 3;

/// The sums of weights over segments that lie one above the other cancel up to this part.
constexpr double kRounding = 1e-15;

double sum_of(const Lanes& lanes) {
    double sum = 0;
    for (int k = 0; k < kLanes; ++k) sum += lanes[k];
    return sum;
}

/// Computes the moments about the site of the regions between the segments and their own bases,
/// over the area of a square, and the weights of the lines.
/// @param p, r  the sides of a square.
PCVT_TARGET_CLONES void integrate_segments(std::span<SegmentBlock> blocks, const GaussRule& rule,
                                           const Vec2& p, const Vec2& r, Moments& moments) {
    Lanes mass{}, first_x{}, first_y{}, second{};
    for (SegmentBlock& block : blocks) {
        Lanes x0, y0, along_x, along_y, left, origin, base;
        std::memcpy(&x0, block.x, sizeof x0);
        std::memcpy(&y0, block.y, sizeof y0);
        std::memcpy(&along_x, block.along_x, sizeof along_x);
        std::memcpy(&along_y, block.along_y, sizeof along_y);
        std::memcpy(&left, block.left, sizeof left);
        std::memcpy(&origin, block.origin, sizeof origin);
        std::memcpy(&base, block.base, sizeof base);
        Lanes rho_left, rho_right, slope_left, slope_right;
        std::memcpy(&rho_left, block.rho_left, sizeof rho_left);
        std::memcpy(&rho_right, block.rho_right, sizeof rho_right);
        std::memcpy(&slope_left, block.slope_left, sizeof slope_left);
        std::memcpy(&slope_right, block.slope_right, sizeof slope_right);
        Lanes l0{}, l1{}, l2{}, r0{}, r1{}, r2{};
        for (int i = 0; i < kPoints; ++i) {
            // The point, its height above the base, and its shares of both lines.
            const Lanes x = x0 + rule.nodes[i] * along_x;
            const Lanes h = y0 + rule.nodes[i] * along_y - base;
            const Lanes to_right = x - left;
            const Lanes to_left = 1 - to_right;
            // Integrate rho, rho t and rho t^2 upwards from the base to the point.
            const Lanes rho = to_left * rho_left + to_right * rho_right;
            const Lanes slope = to_left * slope_left + to_right * slope_right;
            const Lanes hh = h * h;
            const Lanes g = h * rho + hh * slope * (1.0 / 2);
            const Lanes gt = hh * (rho * (1.0 / 2) + h * slope * (1.0 / 3));
            const Lanes gtt = hh * h * (rho * (1.0 / 3) + h * slope * (1.0 / 4));
            // Integrate along x, against the direction of the outline.
            const Lanes w = -rule.weights[i] * along_x;
            const Lanes wg = w * g;
            const Lanes wt = w * gt;
            const Lanes foot_x = p.x() * x + r.x() * base;
            const Lanes foot_y = p.y() * x + r.y() * base;
            mass += wg;
            first_x += wg * foot_x + wt * r.x();
            first_y += wg * foot_y + wt * r.y();
            second += wg * (foot_x * foot_x + foot_y * foot_y) +
                      2 * wt * (foot_x * r.x() + foot_y * r.y()) + w * gtt * r.squaredNorm();
            const Lanes s = x - origin;
            const Lanes w_left = w * to_left;
            const Lanes w_right = w * to_right;
            l0 += w_left;
            l1 += w_left * s;
            l2 += w_left * s * s;
            r0 += w_right;
            r1 += w_right * s;
            r2 += w_right * s * s;
        }
        std::memcpy(block.weights[0], &l0, sizeof l0);
        std::memcpy(block.weights[1], &l1, sizeof l1);
        std::memcpy(block.weights[2], &l2, sizeof l2);
        std::memcpy(block.weights[3], &r0, sizeof r0);
        std::memcpy(block.weights[4], &r1, sizeof r1);
        std::memcpy(block.weights[5], &r2, sizeof r2);
    }
    moments = {sum_of(mass), {sum_of(first_x), sum_of(first_y)}, sum_of(second)};
}

/// The crossings of a side with the lines of one direction, in order.
class Crossings {
   public:
    /// @param from, change  the start of the side and the way to its end, along one axis.
    /// @param in_square     the place of the origin in its square.
    Crossings(double from, double change, double in_square)
        : from_(from + in_square), per_square_(1 / std::abs(change)), step_(change < 0 ? -1 : 1) {
        // A side that leaves a line downwards crosses it at once.
        square_ = static_cast<std::int64_t>(std::floor(from_));
        pass(false);
    }
    /// The part of the side before the next crossing; infinite for a side along the lines.
    double next() const { return next_; }
    std::int64_t square() const { return square_; }
    /// Passes the next crossing, if `wanted`: without a branch, since half of them are wanted.
    void pass(bool wanted) {
        square_ += wanted ? step_ : 0;
        next_ = (double(square_ + (step_ > 0 ? 1 : 0)) - from_) * step_ * per_square_;
    }

   private:
    double from_;
    double per_square_;
    int step_;
    std::int64_t square_;
    double next_;
};

}  // namespace

PixelQuadrature::PixelQuadrature(const PixelGrid& grid, const Eigen::Matrix2d& from_plane)
    : grid_(grid),
      to_squares_(Eigen::Vector2d(grid.width(), grid.height()).asDiagonal() * from_plane),
      p_(to_squares_.inverse().col(0)),
      r_(to_squares_.inverse().col(1)) {}

DensityRange PixelQuadrature::take_range() {
    DensityRange range = grid_.range();
    range.n_evaluations = std::exchange(n_points_, 0);
    return range;
}

/// Cuts a side along the lines of the grid.
void PixelQuadrature::add_side(const Vec2& from, const Vec2& to) {
    const Vec2 change = to - from;
    // There is nothing between a vertical side and a base.
    if (change.x() == 0) return;
    Crossings across(from.x(), change.x(), in_square_.x());
    Crossings up(from.y(), change.y(), in_square_.y());
    for (double done = 0; done < 1;) {
        const double next = std::min({across.next(), up.next(), 1.0});
        if (next > done) {
            segments_.push_back(
                {across.square(), up.square(), from + done * change, (next - done) * change});
            done = next;
        }
        across.pass(across.next() <= next);
        up.pass(up.next() <= next);
    }
}

/// Sorts the segments by columns, and within a column by rows.
void PixelQuadrature::sort_by_column() {
    // Count those of each column.
    const auto by_column = [](const Segment& one, const Segment& other) {
        return one.column < other.column;
    };
    const auto [least, greatest] =
        std::minmax_element(segments_.begin(), segments_.end(), by_column);
    const std::int64_t first = least->column;
    begin_.assign(std::size_t(greatest->column - first) + 2, 0);
    for (const Segment& segment : segments_) ++begin_[std::size_t(segment.column - first) + 1];
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    // Insert each above the lower ones of its column.
    sorted_.resize(segments_.size());
    next_.assign(begin_.begin(), begin_.end() - 1);
    for (const Segment& segment : segments_) {
        const auto c = std::size_t(segment.column - first);
        int at = next_[c]++;
        for (; at > begin_[c] && sorted_[at - 1].row > segment.row; --at) {
            sorted_[at] = sorted_[at - 1];
        }
        sorted_[at] = segment;
    }
}

/// Chooses the base of a column: a line between the lower and the upper sides of the cell, or else
/// one that crosses the cell, or else, in a single row, a point of the cell.
void PixelQuadrature::choose_base(std::size_t c) {
    const double orientation = to_squares_.determinant();
    const Segment& lowest = sorted_[begin_[c]];
    const std::int64_t highest_row = sorted_[begin_[c + 1] - 1].row;
    // Find the end of the lower and the beginning of the upper sides. Rounding may leave a segment
    // of one of them alone in its column.
    std::int64_t low_end = lowest.row;
    std::int64_t high_begin = highest_row + 1;
    for (int k = begin_[c]; k < begin_[c + 1]; ++k) {
        const Segment& segment = sorted_[k];
        if (segment.change.x() * orientation > 0) {
            low_end = std::max(low_end, segment.row + 1);
        } else {
            high_begin = std::min(high_begin, segment.row);
        }
    }
    const bool is_apart = low_end <= high_begin;
    const bool is_point = !is_apart && lowest.row == highest_row;
    const std::int64_t row = is_apart ? low_end : lowest.row + (highest_row - lowest.row + 1) / 2;
    base_rows_[c] = row;
    for (int k = begin_[c]; k < begin_[c + 1]; ++k) {
        const std::int64_t own = sorted_[k].row;
        place(k, lowest.start.x(),
              is_point ? lowest.start.y() : line_below(own < row ? own + 1 : own));
    }
}

/// Fills in a lane of a block.
void PixelQuadrature::place(int k, double origin, double base) {
    const Segment& segment = sorted_[k];
    const PixelGrid::Square f = grid_.square(column_ + segment.column, row_ + segment.row);
    const double up = base - line_below(segment.row);
    SegmentBlock& block = blocks_[k / kLanes];
    const int lane = k % kLanes;
    block.x[lane] = segment.start.x();
    block.y[lane] = segment.start.y();
    block.along_x[lane] = segment.change.x();
    block.along_y[lane] = segment.change.y();
    block.left[lane] = double(segment.column) - in_square_.x();
    block.origin[lane] = origin;
    block.base[lane] = base;
    block.slope_left[lane] = f.high_left - f.low_left;
    block.slope_right[lane] = f.high_right - f.low_right;
    block.rho_left[lane] = f.low_left + up * block.slope_left[lane];
    block.rho_right[lane] = f.low_right + up * block.slope_right[lane];
}

/// Adds the squares between the segments of a column and its base.
void PixelQuadrature::add_column(std::size_t c) {
    const std::int64_t base = base_rows_[c];
    const int begin = begin_[c];
    const int end = begin_[c + 1];
    std::array<double, 6> weights{};
    const auto add_weights = [&](int k, double sign) {
        const SegmentBlock& block = blocks_[k / kLanes];
        for (int w = 0; w < 6; ++w) weights[w] += sign * block.weights[w][k % kLanes];
    };
    // From the highest segment down to the base: the squares below each one.
    for (int k = end - 1; k >= begin && sorted_[k].row > base; --k) {
        add_weights(k, 1);
        add_rows(k, k > begin ? std::max(sorted_[k - 1].row, base) : base, sorted_[k].row, weights);
    }
    // From the lowest segment up to the base: the squares above each one.
    weights = {};
    for (int k = begin; k < end && sorted_[k].row + 1 < base; ++k) {
        add_weights(k, -1);
        add_rows(k, sorted_[k].row + 1, k + 1 < end ? std::min(sorted_[k + 1].row + 1, base) : base,
                 weights);
    }
}

/// Adds the squares of some rows in the column of segment k.
/// @param weights  their parts; see SegmentBlock.
void PixelQuadrature::add_rows(int k, std::int64_t from, std::int64_t end,
                               const std::array<double, 6>& weights) {
    // Where lower and upper segments have the same squares between themselves and the base.
    if (from >= end || std::abs(weights[0] + weights[3]) <= kRounding) return;
    // Integrate with s along x from the origin of the column, and t along y from the first row.
    const auto [left, right] = grid_.run(column_ + sorted_[k].column, row_ + from, row_ + end);
    const double* const w = weights.data();
    const double mass = w[0] * left.mass + w[3] * right.mass;
    const double s = w[1] * left.mass + w[4] * right.mass;
    const double t = w[0] * left.t + w[3] * right.t;
    const double ss = w[2] * left.mass + w[5] * right.mass;
    const double st = w[1] * left.t + w[4] * right.t;
    const double tt = w[0] * left.tt + w[3] * right.tt;
    const Moments rows{mass, s * p_ + t * r_,
                       ss * p_.squaredNorm() + 2 * st * p_.dot(r_) + tt * r_.squaredNorm()};
    moments_ +=
        about_site(rows, blocks_[k / kLanes].origin[k % kLanes] * p_ + line_below(from) * r_);
}

Moments PixelQuadrature::operator()(CellView cell, const Vec2& site) {
    // Find the segments of the sides.
    const Vec2 place(site.x() * grid_.width() - 0.5, site.y() * grid_.height() - 0.5);
    const Vec2 square = place.array().floor();
    column_ = static_cast<std::int64_t>(square.x());
    row_ = static_cast<std::int64_t>(square.y());
    in_square_ = place - square;
    segments_.clear();
    Vec2 from = to_squares_ * cell.back().plane;
    for (const CellCorner& corner : cell) {
        const Vec2 to = to_squares_ * corner.plane;
        add_side(from, to);
        from = to;
    }
    if (segments_.empty()) return {};
    sort_by_column();
    // Choose the bases, and integrate the parts of the squares of the segments.
    const std::size_t n = segments_.size();
    const std::size_t n_columns = begin_.size() - 1;
    blocks_.resize((n + kLanes - 1) / kLanes);
    // Lanes without a segment have no length.
    blocks_.back() = {};
    base_rows_.resize(n_columns);
    for (std::size_t c = 0; c < n_columns; ++c) choose_base(c);
    integrate_segments(blocks_, line_rule(kPoints), p_, r_, moments_);
    // Add the squares between them and the bases.
    for (std::size_t c = 0; c < n_columns; ++c) {
        checkpoint();
        add_column(c);
    }
    n_points_ += static_cast<std::int64_t>(n) * kPoints;
    const double square_area = cross(p_, r_);
    return {square_area * moments_.mass, square_area * moments_.first,
            square_area * moments_.second};
}

}  // namespace pcvt::plane
