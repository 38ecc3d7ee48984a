#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/base/simd.hpp"
#include "mesher/plane/density/pixel_grid.hpp"
#include "mesher/plane/density/quadrature_batch.hpp"

namespace pcvt::plane {

/// The points along a direction of the least rule that is exact for a bilinear density times
/// squares of coordinates.
inline constexpr int kPixelOrder = 3;

/// Segments of the sides of a cell, each in one square; a number per segment, relative to the site,
/// in squares. See PixelQuadrature.
struct SegmentBlock {
    using Column = double[kLanes];

    /// The start of a segment and the change from there to its end.
    Column x, y, along_x, along_y;
    /// The left line of the square, an origin in this column of the cell, and the height of the
    /// base of the segment's own part.
    Column left, origin, base;
    /// The density at both ends of that base, and its changes along the lines beside it.
    Column rho_left, rho_right, slope_left, slope_right;
    /// The integrals of the shares of the left and of the right line times 1, s, s^2, with s along
    /// x from the origin.
    Column weights[6];
};

/// Integrates the density of a picture over cells, exactly up to rounding.
///
/// By Green's theorem the moments are a sum over the sides of the cell. The lines of the grid cut
/// each side into segments, one in each square that the side crosses. A segment contributes the
/// integral over the region between it and the *base* of its column, a horizontal line that lies in
/// the cell wherever one does. That region is a part of the segment's own square, and all squares
/// of the column from there to the base. Over the first part the density is a polynomial, which a
/// Gauss rule integrates; kLanes segments are processed together. The squares need the integrals of
/// the density along the two lines beside them, which PixelGrid returns, and six integrals over
/// segments. Time and memory are proportional to the number of squares that the outline of the cell
/// crosses; another square takes a sixteenth of the time.
///
/// Example usage:
///
///     PixelQuadrature integrate(grid, from_plane);
///     const Moments m = integrate(cell, site);
///
/// Laws, tested by number:
///   (1) The moments are those of CellQuadrature for the same density without its grid.
///   (2) A cell and its translates by lattice vectors have the same moments.
///   (3) The error is a few roundings of the moments for any contrast, but for squares that both
///       the lower and the upper sides of a cell cross: there, of the greatest density times the
///       part of the cell. A basis that is far from reduced adds the square of its shear.
class PixelQuadrature {
   public:
    /// @param grid        must outlive this object.
    /// @param from_plane  the matrix from plane to lattice coordinates.
    PixelQuadrature(const PixelGrid& grid, const Eigen::Matrix2d& from_plane);

    /// @param site  lattice coordinates of the point with plane coordinates (0, 0).
    Moments operator()(CellView cell, const Vec2& site);
    /// The range of the picture, and the number of its evaluations since the last call.
    DensityRange take_range();

   private:
    /// The part of a side in one square.
    struct Segment {
        /// Of its square, relative to that of the site.
        std::int64_t column;
        std::int64_t row;
        /// The start and the change from there to the end, relative to the site; squares.
        Vec2 start;
        Vec2 change;
    };
    void add_side(const Vec2& from, const Vec2& to);
    void sort_by_column();
    void choose_base(std::size_t c);
    void place(int k, double origin, double base);
    void add_column(std::size_t c);
    void add_rows(int k, std::int64_t from, std::int64_t end, const std::array<double, 6>& weights);
    double line_below(std::int64_t row) const { return double(row) - in_square_.y(); }

    const PixelGrid& grid_;
    Eigen::Matrix2d to_squares_;
    /// The sides of a square, in the plane.
    Vec2 p_;
    Vec2 r_;
    std::int64_t n_points_ = 0;
    /// The square of the site, and the place of the site in it.
    std::int64_t column_ = 0;
    std::int64_t row_ = 0;
    Vec2 in_square_;
    /// Those of the cell: side by side, then by columns and rows.
    std::vector<Segment> segments_;
    std::vector<Segment> sorted_;
    /// The first segment of each column, followed by their number.
    std::vector<int> begin_;
    /// The next segment of each column while they are sorted.
    std::vector<int> next_;
    /// The row above the base of each column.
    std::vector<std::int64_t> base_rows_;
    std::vector<SegmentBlock> blocks_;
    /// Over the area of a square.
    Moments moments_;
};

}  // namespace pcvt::plane
