#pragma once

#include <array>
#include <optional>
#include <vector>

#include "mesher/space/grains/grain_surface.hpp"

namespace pcvt::space {

/// The triangles of the faces of one cell, on its own numbered points.
struct CellHull {
    /// Rising images of nodes, in the frame of the cell, and their positions.
    std::vector<NodeImage> images = {};
    std::vector<Vec3> points = {};
    /// Counter-clockwise seen from outside.
    std::vector<std::array<int, 3>> triangles = {};
    /// SharpFeatures::near of the cell; empty if the cell has no sharp feature.
    std::vector<char> near = {};

    /// The number of an image that the hull has.
    int find(const NodeImage& image) const;
};

/// Returns the hulls of the cells.
///
/// Law, tested by number:
///   (1) Each hull is closed: each edge occurs twice, once in each direction.
std::vector<CellHull> cell_hulls(const CellComplex& complex, const GrainSurface& surface);

/// Returns a point from which each triangle of a hull is seen from inside: the centroid, or a point
/// deep inside; nothing if no point is found.
std::optional<Vec3> kernel_point(const CellHull& hull);

}  // namespace pcvt::space
