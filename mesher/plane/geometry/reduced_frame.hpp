#pragma once

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

/// The plane rotated so that the reduced period vector a lies along x: a = (ax, 0), b = (bx, by),
/// in a unit of length that the owner chooses.
///
/// Example usage:
///
///     const ReducedFrame frame{.ax = 1, .bx = 0.5, .by = 0.75};
///     const Vec2 p = frame.to_position({0.5, 1});  // (1, 0.75)
struct ReducedFrame {
    double ax;
    double bx;
    double by;

    Vec2 to_position(const Vec2& u) const { return {ax * u.x() + bx * u.y(), by * u.y()}; }
    Vec2 to_lattice(const Vec2& p) const {
        const double v = p.y() / by;
        return {(p.x() - bx * v) / ax, v};
    }
};

}  // namespace pcvt::plane
