#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The parts of a face below a plane, in it and above it: each a polygon of corners of the face in
/// their order, or empty.
struct FaceParts {
    std::vector<VertexImage> below = {};
    std::vector<VertexImage> inside = {};
    std::vector<VertexImage> above = {};
    /// Whether the plane cuts the face at most twice.
    bool is_sound = true;
};

/// A corner of a face.
struct SidedCorner {
    VertexImage image;
    /// -1 below the plane, 1 above it, and 0 on it.
    int side;
};

/// Divides a face at a plane between the corners that lie on it. Corners that were moved to the
/// plane may be three or more, though the face has others: then the polygon between them may be a
/// part in the plane.
///
/// Example usage:
///     const FaceParts parts = face_parts(corners, [&](const auto& polygon) { return true; });
///
/// Law, tested by number:
///   (1) Parts have corners of the face on their side or on the plane, and if they are n in all,
///       the polygons have n - 2 triangles in all.
///
/// @param corners  neighbours lie on one side of the plane, or one of them lies on it.
/// @param is_flat  whether the polygon of corners on the plane is a part of the face.
FaceParts face_parts(std::span<const SidedCorner> corners,
                     const std::function<bool(std::span<const VertexImage>)>& is_flat);

}  // namespace pcvt::space
