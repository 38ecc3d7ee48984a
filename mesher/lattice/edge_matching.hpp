#pragma once

#include "mesher/lattice/sites.hpp"

namespace pcvt {

/// A halfedge on the torus: from `origin` to `target` + offset, where both are orbits.
struct DirectedEdge {
    int origin;
    int target;
    Offset offset;
};

/// For each halfedge the index of the one that runs the other way along the same edge.
/// @throws InternalError unless every edge has exactly two sides.
std::vector<int> match_edges(const std::vector<DirectedEdge>& halfedges);

}  // namespace pcvt
