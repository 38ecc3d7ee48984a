#pragma once

#include <string>

#include "io/run_files/png_image.hpp"
#include "mesher/plane/density/density.hpp"

namespace pcvt {

/// The densities of black and of white, both positive; either of them may be larger.
struct GreyRange {
    double black = 0.01;
    double white = 1;
};

/// Returns the density of an image that covers the fundamental domain, with its lower left corner
/// at (u, v) = (0, 0) and row 0 at v = 1. The centre of pixel k along u lies at (k + 1/2) / width.
/// Between the centres the density is bilinear, also across the seam. Its kinks are break lines, so
/// that integrals over cells are exact.
///
/// Example usage:
///     const Density density = png_density("spacing.png", {.black = 0.01, .white = 1});
///     const std::vector<double> rho = densities_at(density, lattice, points);
plane::Density image_density(GreyImage image, const GreyRange& range);

/// Returns the density of a PNG file.
/// @throws BadFile, LimitExceeded as decode_png() does; BadFile also if the file cannot be read,
///         LimitExceeded also for more than 256 MiB.
plane::Density png_density(const std::string& path, const GreyRange& range);

/// Returns the height over the width of the picture in a PNG file. @throws as png_density().
double png_height_over_width(const std::string& path);

}  // namespace pcvt
