#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "mesher/plane/density/density.hpp"

namespace pcvt::testing {

inline double value_at(const plane::DensityFunction& function, const plane::DensityPoint& point) {
    double rho = 0;
    function({&point, 1}, {&rho, 1});
    return rho;
}

/// A density of some coordinates, the others being 0, that also takes points by columns.
template <class Function>
plane::Density density_of_columns(Function function, const std::array<bool, 4>& uses) {
    const auto used = [=](std::size_t k, double number) { return uses[k] ? number : 0; };
    return {[=]() -> plane::DensityFunction {
        return {plane::DensityFunction::OfPoints([=](std::span<const plane::DensityPoint> points,
                                                     std::span<double> rho) {
                    for (std::size_t k = 0; k < points.size(); ++k) {
                        const plane::DensityPoint& p = points[k];
                        rho[k] = function({used(0, p.x), used(1, p.y), used(2, p.u), used(3, p.v)});
                    }
                }),
                [=](const plane::PointColumns& points, double* rho) {
                    const auto number = [&](std::size_t i, std::size_t k) {
                        return uses[i] ? points.coordinate[i][k] : 0;
                    };
                    for (std::size_t k = 0; k < points.n; ++k) {
                        rho[k] = function({number(0, k), number(1, k), number(2, k), number(3, k)});
                    }
                },
                uses};
    }};
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
