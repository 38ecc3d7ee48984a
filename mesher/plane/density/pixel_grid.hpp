#pragma once

#include <cstdint>
#include <vector>

#include "mesher/plane/density/density.hpp"

namespace pcvt::plane {

/// Integrals of a density along a line of pixel centres, upwards: of rho, rho t and rho t^2, with t
/// in squares.
struct LineMoments {
    double mass = 0;
    double t = 0;
    double tt = 0;

    /// Adds moments whose origin lies at t = `up`.
    void add(const LineMoments& other, double up);
};

/// A density on the torus that is bilinear between the centres of the pixels of a picture.
///
/// The centre of the pixel of a column and a row lies at u = (column + 1/2) / width, v = (row +
/// 1/2) / height; row 0 is the lowest one. Four neighbouring centres are the corners of a *square*;
/// the square of a column and a row has its lower left corner at the centre of that pixel. Columns
/// and rows are periodic.
///
/// Across a column of squares the density is linear between its two lines of pixel centres. Sums
/// over blocks of rows make the integrals along lines cheap: their cost is proportional to the
/// length over 16. All numbers that are added up are positive, so that the relative error is a few
/// roundings for any contrast.
///
/// Example usage:
///
///     const PixelGrid grid(2, 2, {0, 0.25F, 0.5F, 1}, 1, 5);
///     const double rho = grid.at(0.25, 0.25);          // 1
///     const auto [left, right] = grid.run(0, 0, 2);    // all of two lines
///
/// Laws, tested by number:
///   (1) A run has the sums of the moments of its squares.
///   (2) A run that begins k heights further up has the same moments.
class PixelGrid {
   public:
    /// @param greys  of the pixels, from 0 to 1, row by row from the lowest one.
    /// @param black  rho where grey is 0.
    /// @param white  rho where grey is 1.
    PixelGrid(int width, int height, std::vector<float> greys, double black, double white);

    int width() const { return width_; }
    int height() const { return height_; }
    /// rho at a point.
    /// @param u, v  in [0, 1].
    double at(double u, double v) const;
    /// The values of rho at the corners of a square: lower left, lower right, upper left, upper
    /// right.
    struct Square {
        double low_left;
        double low_right;
        double high_left;
        double high_right;
    };
    Square square(std::int64_t column, std::int64_t row) const;
    /// The lines at the left and at the right of a column of squares.
    struct Run {
        LineMoments left;
        LineMoments right;
    };
    /// From the line below a row to that below the row `end`; t begins at the first of them.
    Run run(std::int64_t column, std::int64_t row, std::int64_t end) const;

    /// The integral of rho over the domain, for a domain of area 1.
    double mean() const { return mean_; }
    /// The least and the greatest value of rho.
    const DensityRange& range() const { return range_; }

   private:
    double value(float grey) const { return black_ + (white_ - black_) * grey; }
    const float* line(std::int64_t row) const { return greys_.data() + row * width_; }
    Run short_run(int left, int row, int end) const;
    void survey();
    void fill_blocks();

    int width_;
    int height_;
    std::vector<float> greys_;
    double black_;
    double white_;
    double mean_ = 0;
    DensityRange range_;
    /// For each block of rows the moments along each line.
    std::vector<LineMoments> blocks_;
};

/// The density of a grid. Its break lines run through the centres of the pixels.
Density pixel_density(PixelGrid grid);

}  // namespace pcvt::plane
