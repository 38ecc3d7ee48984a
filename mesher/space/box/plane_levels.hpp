#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// Returns a normal of the planes on which a coordinate of lattice.to_lattice(position) is an
/// integer, towards larger coordinates.
Vec3 upwards(const Lattice& lattice, int axis);

/// The parallel planes on which one coordinate of u = lattice.to_lattice(position - origin) is an
/// integer.
class AxisPlanes {
   public:
    AxisPlanes(const Lattice& lattice, int axis, const Vec3& origin)
        : lattice_(lattice), axis_(axis), origin_(origin) {}

    /// The coordinate of a point, and how far it is from a plane, length units.
    double height(const Vec3& p) const { return lattice_.to_lattice(p - origin_)[axis_]; }
    double distance(int plane, const Vec3& p) const {
        return std::abs(height(p) - plane) * spacing();
    }
    /// The distance between two planes.
    double spacing() const { return lattice_.heights()[axis_]; }
    /// Moves a point along the period vector.
    void put_on(int plane, Vec3& p) const { p += (plane - height(p)) * lattice_.periods()[axis_]; }
    Vec3 up() const { return upwards(lattice_, axis_); }

   private:
    const Lattice& lattice_;
    int axis_;
    const Vec3& origin_;
};

/// How near to a plane vertices lie on it, length units.
struct Nearness {
    /// All vertices.
    double all;
    /// Vertices that lie on a plane unless an edge or a face at them would almost vanish: then the
    /// distance is their shortest edge over kEdgeOverSnap, but at least `all`.
    double snapped = 0;
};
inline constexpr double kEdgeOverSnap = 8;

/// The lowest and the highest of levels: 2 k on the plane u = k, and 2 k + 1 in slab k, between
/// that and the next one.
struct LevelRange {
    int low = std::numeric_limits<int>::max();
    int high = std::numeric_limits<int>::min();

    void add(int level) {
        low = std::min(low, level);
        high = std::max(high, level);
    }
    int first_slab() const { return low >> 1; }
    int last_slab() const { return (high - 1) >> 1; }
};

/// Moves vertices that lie on a plane exactly there.
/// @returns the level of each vertex.
std::vector<int> put_on_planes(const AxisPlanes& planes, const Nearness& near,
                               CellComplex& complex);

}  // namespace pcvt::space
