#pragma once

#include <vector>

#include "mesher/space/mesh/cell_complex.hpp"

namespace pcvt::space {

/// The corners of a face in the order of its boundary.
using Corners = std::vector<VertexImage>;

/// Whether faces are those of a polyhedron: they bound a ball, and any two of them share nothing, a
/// corner, or a chain of edges. Without the inner corners of chains, which lie on straight edges of
/// the polyhedron, any two share at most one edge, as those of a convex polyhedron do.
///
/// Example usage:
///   const Corners a{{0, {}}, {1, {}}, {2, {}}};  // and b, c, d
///   assert(is_polyhedron({a, b, c, d}));
///
/// @param faces  counter-clockwise seen from outside.
bool is_polyhedron(const std::vector<Corners>& faces);

}  // namespace pcvt::space
