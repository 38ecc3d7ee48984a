#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/forms/surface_mesh.hpp"
#include "mesher/base/site_id.hpp"

namespace pcvt {

/// A point, a normal or a colour in single precision.
using Point3 = std::array<float, 3>;

/// Viewers slow down beyond about this number of nodes.
inline constexpr int kMaxCellNodes = 2000;

/// A member of extras.periodic: its JSON, or numbers that the buffer holds in single precision.
struct GltfExtra {
    std::string key;
    std::string json;
    /// Rows of this width; then the member is the index of their accessor.
    std::vector<float> numbers = {};
    std::size_t width = 0;
};

/// A surface mesh with the quantities that glTF shows beside it. Each group is a node, with a
/// primitive for each run of faces of one colour; classes beyond those of the faces are colours of
/// points.
struct GltfSurface {
    SurfaceMesh mesh;
    /// One a point, whose faces are triangles that share their points; none: each face has points
    /// of its own, with its normal.
    std::vector<Point3> normals = {};
    /// The site of each point, or none.
    std::vector<SiteId> vertex_site = {};
    /// The ends of lines on the points, two each, which are drawn above the surface.
    std::vector<int> lines = {};
    /// The place of the points, length units.
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();
    std::vector<GltfExtra> extras = {};
};

}  // namespace pcvt
