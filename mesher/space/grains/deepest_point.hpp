#pragma once

#include <vector>

#include "mesher/space/geometry/lattice.hpp"

namespace pcvt::space {

/// The points x with normal . x <= height.
struct HalfSpace {
    Vec3 normal;
    double height;
};

/// Returns the point whose least depth in half-spaces with unit normals is largest, up to rounding:
/// the centre of the largest ball in a polyhedron. If no point lies in all of them, one that is
/// outside by least. Solves the linear program by adding one half-space after the other (Seidel,
/// 1991: "Small-dimensional linear programming and convex hulls made easy").
///
/// Example usage:
///     const Vec3 centre = deepest_point(half_spaces, somewhere, size);
///
/// Law, tested by number:
///   (1) No other point is deeper by more than rounding.
/// Cost: proportional to the number of half-spaces.
///
/// @param near    the middle of the cube in which the point is searched.
/// @param extent  half of the edge of the cube, and the greatest depth; length units.
Vec3 deepest_point(const std::vector<HalfSpace>& half_spaces, const Vec3& near, double extent);

}  // namespace pcvt::space
