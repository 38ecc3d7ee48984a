#pragma once

#include <array>

#include "mesher/space/delaunay/predicates.hpp"

namespace pcvt::space {

/// Space rotated so that the reduced period a lies along x and b in the plane x, y: a = (ax, 0, 0),
/// b = (bx, by, 0), c = (cx, cy, cz), in a unit of length that the owner chooses.
///
/// Example usage:
///
///     const Frame frame(reduced, unit);
///     const Vec3 p = frame.to_space({0.5, 1, 0});
struct Frame {
    double ax = 1;
    double bx = 0;
    double by = 1;
    double cx = 0;
    double cy = 0;
    double cz = 1;
    /// The metric of the predicates, in a unit of its own.
    Gram gram{1, 0, 0, 1, 0, 1};

    Frame() = default;
    /// @param reduced  right-handed.
    Frame(const Lattice& reduced, double unit);

    Vec3 to_space(const Vec3& u) const {
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

/// The contributions of many tetrahedra to the energy, its gradient and the volumes of the cells
/// (energy.hpp), without branches.
struct TetrahedronBlock {
    static constexpr int kSize = 32;
    using Row = std::array<double, kSize>;

    /// Input: corners 1, 2 and 3 relative to corner 0, coordinates of the reduced basis.
    std::array<std::array<Row, 3>, 3> corner;
    /// Output: x, y and z of the gradient at a corner, and the volume there; for each corner.
    std::array<std::array<Row, 4>, 4> terms;
    Row value;
    /// Lower bounds of the heights of the circumcentre above the facets, each times twice the area
    /// of its facet; minus infinity if the tetrahedron is not thick.
    std::array<Row, 4> height;
    /// Positive where the tetrahedron is certainly positively oriented and not thin.
    Row thick;
    /// Positive where the heights and `thick` are, which they are for most tetrahedra.
    Row certain;

    void compute(const Frame& frame);
    /// Replaces the contributions of tetrahedron k by those for its exact circumcentre: that of a
    /// flat tetrahedron, which doubles do not give, made those of compute() arbitrary.
    void correct(int k, const Frame& frame);
};

}  // namespace pcvt::space
