#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "io/gltf/space_gltf.hpp"

namespace pcvt {

/// The relative rounding of the coordinates of glTF.
inline constexpr double kSingleEpsilon = std::numeric_limits<float>::epsilon();

/// The measures of a face whose corners may be rounded.
///
/// Example usage:
///     const FaceSize face(surface.points, surface.faces[f]);
///     const space::Vec3 normal = face.area.stableNormalized();
struct FaceSize {
    space::Vec3 centre = space::Vec3::Zero();
    /// The sum of the area vectors of its triangles.
    space::Vec3 area = space::Vec3::Zero();
    double perimeter = 0;
    double shortest_edge = std::numeric_limits<double>::infinity();
    int n_corners;

    FaceSize(const std::vector<space::Vec3>& points, std::span<const int> face)
        : n_corners(static_cast<int>(face.size())) {
        const space::Vec3& first = points[face.front()];
        space::Vec3 from = points[face.back()];
        for (const int v : face) {
            const space::Vec3& to = points[v];
            centre += to;
            area += (from - first).cross(to - first) / 2;
            perimeter += (to - from).norm();
            shortest_edge = std::min(shortest_edge, (to - from).norm());
            from = to;
        }
        centre /= double(n_corners);
    }
    /// The error of a direction by errors of the corners of this size; infinite for a face without
    /// area.
    double tilt(double error) const {
        const double moved = perimeter + 2 * error * n_corners;
        return area.norm() > 0 ? error * moved / area.norm()
                               : std::numeric_limits<double>::infinity();
    }
};

/// The normal that a file states at a point.
inline space::Vec3 stated_normal(const GlbSurfaces& glb, int v) {
    const auto& [x, y, z] = glb.normals[v];
    return {x, y, z};
}

}  // namespace pcvt
