#pragma once

#include <string>

#include "io/run_files/png_image.hpp"
#include "mesher/density/density.hpp"

namespace pcvt {

/// The densities of black and of white, both positive; either may be the larger one.
struct GreyRange {
    double black = 0.01;
    double white = 1;
};

/// The density of a picture laid over the fundamental domain: its lower left corner at
/// (u, v) = (0, 0), row 0 at v = 1. The centre of pixel k along u lies at (k + 1/2) / width; in
/// between the density is bilinear, across the seam as well. Its kinks are break lines, so that
/// integrals over cells are exact.
Density image_density(GreyImage image, const GreyRange& range);

/// The same of a PNG file.
/// @throws BadFile, LimitExceeded as decode_png does, and where it cannot be read.
Density png_density(const std::string& path, const GreyRange& range);

}  // namespace pcvt
