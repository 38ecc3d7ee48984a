#pragma once

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// The plane turned so that the reduced period vector a lies along x, a = (ax, 0), b = (bx, by), in
/// some unit of length.
struct ReducedFrame {
    double ax;
    double bx;
    double by;

    Vec2 to_plane(const Vec2& u) const { return {ax * u.x() + bx * u.y(), by * u.y()}; }
};

}  // namespace pcvt
