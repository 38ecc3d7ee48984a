#pragma once

#include <array>
#include <vector>

#include "mesher/space/mesh/tetrahedral_mesh.hpp"

namespace pcvt::space {

/// The corners at the ends of the edges of a tetrahedron, in the order in which VTK, Abaqus and
/// CalculiX number the nodes in their middle. Gmsh exchanges the last two.
inline constexpr std::array<std::array<int, 2>, 6> kEdgeCorners{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// The nodes in the middle of the edges of a tile, by which its tetrahedra become ten-node
/// tetrahedra with straight edges. They are numbered on from the points of the tile.
///
/// Laws, tested by number:
///   (1) Each edge of the tile has one node, and all tetrahedra at an edge share it.
///   (2) Of the nodes on the images of an edge one is the representative, in the middle of its
///       edge; each other one is the representative + translation, computed once.
struct MidsideNodes {
    /// points[k] is the position of node n_points() + k, length units.
    std::vector<Vec3> points = {};
    /// The nodes of each tetrahedron, in the order of kEdgeCorners.
    std::vector<std::array<int, 6>> of_tetrahedron = {};
    /// For node n_points() + k the representative, which has the smallest number, and the offset
    /// from there.
    std::vector<int> orbit = {};
    std::vector<Offset> offset = {};
};

/// Example usage:
///   const MidsideNodes middles = midside_nodes(mesh);
///   for (const int v : middles.of_tetrahedron[t]) element.push_back(v);
///
/// Cost: t log t for t tetrahedra.
MidsideNodes midside_nodes(const TetrahedralMesh& mesh);

/// Returns the tile with tetrahedra of that order.
TetrahedralMesh of_order(int order, TetrahedralMesh mesh);

}  // namespace pcvt::space
