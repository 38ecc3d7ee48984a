#pragma once

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {

/// A halfedge on the torus, from orbit `origin` to orbit `target` translated by the offset.
struct DirectedEdge {
    int origin;
    int target;
    Offset offset;
};

/// Returns for each halfedge the index of its opposite, which runs along the same edge in the other
/// direction.
///
/// Example usage (one site: two triangles, three edges between images of the site):
///
///     const std::vector<int> opposite = match_edges({
///         {0, 0, {1, 0}}, {0, 0, {0, 1}}, {0, 0, {-1, -1}},
///         {0, 0, {1, 1}}, {0, 0, {-1, 0}}, {0, 0, {0, -1}}});
///
/// @throws InternalError unless every edge has exactly two sides.
std::vector<int> match_edges(const std::vector<DirectedEdge>& halfedges);

}  // namespace pcvt::plane
