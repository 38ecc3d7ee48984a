#pragma once

#include "mesher/space/delaunay/predicates.hpp"

namespace pcvt::space {

/// Space rotated so that the reduced period a lies along x and b in the plane x, y: a = (ax, 0, 0),
/// b = (bx, by, 0), c = (cx, cy, cz), in a unit of length that the owner chooses.
///
/// Example usage:
///
///     const Frame frame(reduced, unit);
///     const Vec3 p = frame.to_position({0.5, 1, 0});
struct Frame {
    double ax = 1;
    double bx = 0;
    double by = 1;
    double cx = 0;
    double cy = 0;
    double cz = 1;
    /// The metric of the predicates, in a unit of its own.
    Gram gram{1, 0, 0, 1, 0, 1};
    /// A squared length in that unit over the same one in the square of the owner's unit.
    double gram_per_square = 1;

    Frame() = default;
    /// @param reduced  right-handed.
    Frame(const Lattice& reduced, double unit);

    Vec3 to_position(const Vec3& u) const {
        return {ax * u.x() + bx * u.y() + cx * u.z(), by * u.y() + cy * u.z(), cz * u.z()};
    }
    Vec3 to_lattice(const Vec3& p) const {
        const double w = p.z() / cz;
        const double v = (p.y() - cy * w) / by;
        return {(p.x() - bx * v - cx * w) / ax, v, w};
    }
    /// Volume of the fundamental domain, unit^3.
    double volume() const { return ax * by * cz; }
};

}  // namespace pcvt::space
