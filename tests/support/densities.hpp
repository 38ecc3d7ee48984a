#pragma once

#include <cmath>
#include <numbers>

#include "mesher/plane/density/density.hpp"

namespace pcvt::testing {

inline double value_at(const plane::DensityFunction& function, const plane::DensityPoint& point) {
    double rho = 0;
    function({&point, 1}, {&rho, 1});
    return rho;
}

/// exp(sin 2 pi u + cos 2 pi v): contrast 55.
inline plane::Density smooth_density() {
    return plane::shared_density([](const plane::DensityPoint& p) {
        return std::exp(std::sin(2 * std::numbers::pi * p.u) +
                        std::cos(2 * std::numbers::pi * p.v));
    });
}

/// A ridge of contrast 1:100 along v = 1/2.
inline plane::Density ridge_density() {
    return plane::shared_density([](const plane::DensityPoint& p) {
        const double d = (p.v - 0.5) / 0.1;
        return 1 + 99 * std::exp(-d * d);
    });
}

/// A ramp of contrast 1:100, with a jump at the seam.
inline plane::Density ramp_density() {
    return plane::shared_density([](const plane::DensityPoint& p) { return 1 + 99 * p.u; });
}

/// 2 x 2 squares of 1 and 100.
inline plane::Density checkerboard() {
    return plane::shared_density(
        [](const plane::DensityPoint& p) { return (p.u < 0.5) == (p.v < 0.5) ? 100.0 : 1.0; });
}

/// A jump along a circle, which no break line follows.
inline plane::Density disc_density() {
    return plane::shared_density([](const plane::DensityPoint& p) {
        return std::hypot(p.u - 0.5, p.v - 0.5) < 0.3 ? 100.0 : 1.0;
    });
}

}  // namespace pcvt::testing
