#pragma once

#include <span>
#include <vector>

#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {

/// Fills `polygon` with the corners of a face, in the memory that it has.
inline void face_polygon(const std::vector<Vec2>& points, std::span<const int> face,
                         Polygon& polygon) {
    polygon.clear();
    for (const int v : face) polygon.push_back(points[v]);
}

/// Returns the corners of a face.
///
/// Example usage:
///   const double area = polygon_area(face_polygon(tile.points, tile.faces[f]));
inline Polygon face_polygon(const std::vector<Vec2>& points, std::span<const int> face) {
    Polygon polygon;
    face_polygon(points, face, polygon);
    return polygon;
}

}  // namespace pcvt::plane
