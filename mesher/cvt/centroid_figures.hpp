#pragma once

namespace pcvt {

/// The distances of the centroids of cells from prescribed ones, in units of h.
///
/// Example usage:
///     const CentroidFigures& figures = *cells.centroids;
///     std::printf("%g h on average, %g h at most\n", figures.mean, figures.largest);
struct CentroidFigures {
    double largest = 0;
    double mean = 0;
};

}  // namespace pcvt
