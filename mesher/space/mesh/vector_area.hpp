#pragma once

#include <Eigen/Geometry>
#include <cstddef>

#include "mesher/space/geometry/lattice.hpp"

namespace pcvt::space {

/// Returns twice the vector area of a polygon, the sum over the fan of triangles from its first
/// corner. It points to where the corners run counter-clockwise.
///
/// Example usage:
///     const Vec3 twice = twice_vector_area(complex.corners_of(f), [&](const VertexImage& corner) {
///         return complex.position(corner);
///     });
///
/// @param at  the position of a corner.
template <class Corners, class At>
Vec3 twice_vector_area(const Corners& corners, const At& at) {
    const Vec3 first = at(corners[0]);
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        sum += (at(corners[k]) - first).cross(at(corners[k + 1]) - first);
    }
    return sum;
}

}  // namespace pcvt::space
