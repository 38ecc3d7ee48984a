#pragma once

#include <functional>

#include "mesher/space/mesh/polyhedron_graph.hpp"

namespace pcvt::space {

/// An edge from vertex `from` in the domain to an image of vertex `to`.
struct ShortEdge {
    /// Length units.
    double length;
    int from;
    VertexImage to;
};

/// Returns the corners of a face when an edge is shrunk to its first end: an image of `to` becomes
/// one of `from`. Fewer than three are left of a face that vanishes.
Corners shrunk(Corners corners, const ShortEdge& edge);

/// Returns the sharpest corner of a face, degrees; `position` gives the place of a corner.
double sharpest_corner(const Corners& corners,
                       const std::function<Vec3(const VertexImage&)>& position);

}  // namespace pcvt::space
