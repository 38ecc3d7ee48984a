#include "mesher/plane/density/pixel_quadrature.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/density/cell_cuts.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {
namespace {

/// The line of a number, in lattice coordinates.
double line_at(std::int64_t number, int n) { return (double(number) + 0.5) / n; }

/// The last line at or below a coordinate.
std::int64_t line_below(double coordinate, int n) {
    auto number = static_cast<std::int64_t>(std::floor(coordinate * n - 0.5));
    // Rounding may have crossed a line.
    while (line_at(number, n) > coordinate) --number;
    while (line_at(number + 1, n) <= coordinate) ++number;
    return number;
}

std::int64_t line_above(double coordinate, int n) {
    const std::int64_t below = line_below(coordinate, n);
    return line_at(below, n) == coordinate ? below : below + 1;
}

/// The lowest and the highest corner of a strip on one of its two lines.
struct StripSide {
    const CellCorner* low = nullptr;
    const CellCorner* high = nullptr;

    void add(const CellCorner& corner) {
        if (low == nullptr || corner.lattice.y() < low->lattice.y()) low = &corner;
        if (high == nullptr || corner.lattice.y() > high->lattice.y()) high = &corner;
    }
    /// The point of the side at a height between both, in the plane.
    Vec2 at(double v) const {
        const double share = (v - low->lattice.y()) / (high->lattice.y() - low->lattice.y());
        return low->plane + share * (high->plane - low->plane);
    }
};

/// The bilinear density of a square at lattice coordinates, and its change along a vector.
class SquareDensity {
   public:
    SquareDensity(const PixelGrid& grid, std::int64_t column, std::int64_t row)
        : f_(grid.square(column, row)),
          origin_(line_at(column, grid.width()), line_at(row, grid.height())),
          per_square_(grid.width(), grid.height()) {}

    Vec2 place(const Vec2& lattice) const { return change(lattice - origin_); }
    Vec2 change(const Vec2& lattice) const { return lattice.cwiseProduct(per_square_); }
    double operator()(const Vec2& st) const {
        const double low = f_.low_left + st.x() * (f_.low_right - f_.low_left);
        const double high = f_.high_left + st.x() * (f_.high_right - f_.high_left);
        return low + st.y() * (high - low);
    }

   private:
    PixelGrid::Square f_;
    Vec2 origin_;
    Vec2 per_square_;
};

/// The sums over the parts of one cell.
class CellOnPixels {
   public:
    explicit CellOnPixels(const PixelGrid& grid) : grid_(grid) {}

    /// Adds the part of the cell in a column of squares.
    void add_strip(CellView strip, std::int64_t column);
    const Moments& moments() const { return moments_; }
    std::int64_t n_points() const { return n_points_; }

   private:
    void add_run(const StripSide& left, const StripSide& right, std::int64_t column,
                 std::int64_t row, std::int64_t end);
    void add_pieces(CellView strip, std::int64_t column);
    void add_piece(CellView piece, std::int64_t column, std::int64_t row);

    const PixelGrid& grid_;
    Moments moments_;
    std::int64_t n_points_ = 0;
    CellPolygon rest_, below_, above_;
    CellPolygon piece_rest_, piece_, piece_above_;
};

void CellOnPixels::add_strip(CellView strip, std::int64_t column) {
    // Find the squares of the column that lie in the cell, which is convex.
    const double from = line_at(column, grid_.width());
    const double to = line_at(column + 1, grid_.width());
    StripSide left;
    StripSide right;
    for (const CellCorner& corner : strip) {
        if (corner.lattice.x() == from) left.add(corner);
        if (corner.lattice.x() == to) right.add(corner);
    }
    if (left.low == nullptr || right.low == nullptr) return add_pieces(strip, column);
    const std::int64_t row =
        line_above(std::max(left.low->lattice.y(), right.low->lattice.y()), grid_.height());
    const std::int64_t end =
        line_below(std::min(left.high->lattice.y(), right.high->lattice.y()), grid_.height());
    if (row >= end) return add_pieces(strip, column);
    // Add these, and the parts of squares below and above them.
    add_run(left, right, column, row, end);
    cut(strip, 1, line_at(row, grid_.height()), below_, above_);
    if (below_.size() >= 3) add_pieces(below_, column);
    rest_.swap(above_);
    cut(rest_, 1, line_at(end, grid_.height()), below_, above_);
    if (above_.size() >= 3) add_pieces(above_, column);
}

void CellOnPixels::add_run(const StripSide& left, const StripSide& right, std::int64_t column,
                           std::int64_t row, std::int64_t end) {
    const double low = line_at(row, grid_.height());
    const Vec2 corner = left.at(low);
    // The width and the height of one square, in the plane.
    const Vec2 p = right.at(low) - corner;
    const Vec2 r = (left.at(line_at(end, grid_.height())) - corner) / double(end - row);
    PlainMoments sum = grid_.run(column, row, end);
    const double area = std::abs(cross(p, r));
    const Moments run{
        area * sum.mass, area * (sum.s * p + sum.t * r),
        area * (sum.ss * p.squaredNorm() + 2 * sum.st * p.dot(r) + sum.tt * r.squaredNorm())};
    moments_ += about_site(run, corner);
}

/// Cuts a part of a strip between the rows.
void CellOnPixels::add_pieces(CellView strip, std::int64_t column) {
    const auto [lowest, highest] = std::minmax_element(
        strip.begin(), strip.end(), [](const CellCorner& one, const CellCorner& other) {
            return one.lattice.y() < other.lattice.y();
        });
    std::int64_t row = line_below(lowest->lattice.y(), grid_.height());
    const double top = highest->lattice.y();
    piece_rest_.assign(strip.begin(), strip.end());
    for (; line_at(row + 1, grid_.height()) < top; ++row) {
        cut(piece_rest_, 1, line_at(row + 1, grid_.height()), piece_, piece_above_);
        if (piece_.size() >= 3) add_piece(piece_, column, row);
        piece_rest_.swap(piece_above_);
    }
    if (piece_rest_.size() >= 3) add_piece(piece_rest_, column, row);
}

/// Adds a part of one square: the fan of triangles from its first corner.
void CellOnPixels::add_piece(CellView piece, std::int64_t column, std::int64_t row) {
    const TriangleRule& rule = triangle_rule(kPixelOrder);
    const SquareDensity rho(grid_, column, row);
    const CellCorner& apex = piece[0];
    const Vec2 place = rho.place(apex.lattice);
    Moments fan;
    for (std::size_t c = 1; c + 1 < piece.size(); ++c) {
        const Vec2 p = piece[c].plane - apex.plane;
        const Vec2 r = piece[c + 1].plane - apex.plane;
        const Vec2 along_p = rho.change(piece[c].lattice - apex.lattice);
        const Vec2 along_r = rho.change(piece[c + 1].lattice - apex.lattice);
        Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
        for (int k = 0; k < rule.n_points(); ++k) {
            sum += rho(place + rule.along_p[k] * along_p + rule.along_r[k] * along_r) *
                   rule.weights.col(k);
        }
        // Coincident corners make triangles that consist of rounding only.
        sum *= std::max(cross(p, r), 0.0);
        fan += {sum[0], sum[1] * p + sum[2] * r,
                sum[3] * p.squaredNorm() + 2 * sum[4] * p.dot(r) + sum[5] * r.squaredNorm()};
        n_points_ += rule.n_points();
    }
    moments_ += about_site(fan, apex.plane);
}

}  // namespace

Moments pixel_moments(const PixelGrid& grid, CellView cell, std::int64_t& n_points) {
    double low = cell[0].lattice.x();
    double high = low;
    for (const CellCorner& corner : cell) {
        low = std::min(low, corner.lattice.x());
        high = std::max(high, corner.lattice.x());
    }
    CellOnPixels sum(grid);
    CellPolygon rest(cell.begin(), cell.end());
    CellPolygon strip;
    CellPolygon right;
    std::int64_t column = line_below(low, grid.width());
    for (; line_at(column + 1, grid.width()) < high; ++column) {
        checkpoint();
        cut(rest, 0, line_at(column + 1, grid.width()), strip, right);
        if (strip.size() >= 3) sum.add_strip(strip, column);
        rest.swap(right);
    }
    if (rest.size() >= 3) sum.add_strip(rest, column);
    n_points += sum.n_points();
    return sum.moments();
}

}  // namespace pcvt::plane
