#pragma once

#include "mesher/plane/density/pixel_grid.hpp"
#include "mesher/plane/density/quadrature_batch.hpp"

namespace pcvt::plane {

/// The points along a direction of the least rule that is exact for a bilinear density times
/// squares of coordinates.
inline constexpr int kPixelOrder = 3;

/// Integrates the density of a picture over cells, exactly up to rounding.
///
/// The lines between the columns of squares cut a cell into strips. In each strip the squares that
/// lie in the cell are one run, whose moments PixelGrid returns; the parts of squares below and
/// above it are fans of triangles. Time is proportional to the squares that the outline of the cell
/// crosses, and a sixteenth of the others; no memory is needed for either.
///
/// Example usage:
///
///     std::int64_t n_points = 0;
///     const Moments m = pixel_moments(grid, cell, n_points);
///
/// Laws, tested by number:
///   (1) The moments are those of CellQuadrature for the same density without its grid.
///   (2) A cell and its translates by lattice vectors have the same moments.
///
/// @param n_points  raised by the number of points at which the density was evaluated.
Moments pixel_moments(const PixelGrid& grid, CellView cell, std::int64_t& n_points);

}  // namespace pcvt::plane
