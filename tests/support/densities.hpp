#pragma once

#include <cmath>
#include <numbers>

#include "mesher/density/density.hpp"

namespace pcvt::testing {

inline double value_at(const DensityFunction& function, const DensityPoint& point) {
    double rho = 0;
    function({&point, 1}, {&rho, 1});
    return rho;
}

/// exp(sin 2 pi u + cos 2 pi v): contrast 55.
inline Density smooth_density() {
    return shared_density([](const DensityPoint& p) {
        return std::exp(std::sin(2 * std::numbers::pi * p.u) +
                        std::cos(2 * std::numbers::pi * p.v));
    });
}

/// A ridge of contrast 1:100 along v = 1/2.
inline Density ridge_density() {
    return shared_density([](const DensityPoint& p) {
        const double d = (p.v - 0.5) / 0.1;
        return 1 + 99 * std::exp(-d * d);
    });
}

/// A ramp of contrast 1:100, with a jump at the seam.
inline Density ramp_density() {
    return shared_density([](const DensityPoint& p) { return 1 + 99 * p.u; });
}

/// 2 x 2 squares of 1 and 100.
inline Density checkerboard() {
    return shared_density(
        [](const DensityPoint& p) { return (p.u < 0.5) == (p.v < 0.5) ? 100.0 : 1.0; });
}

/// A jump along a circle, which no break line follows.
inline Density disc_density() {
    return shared_density(
        [](const DensityPoint& p) { return std::hypot(p.u - 0.5, p.v - 0.5) < 0.3 ? 100.0 : 1.0; });
}

}  // namespace pcvt::testing
