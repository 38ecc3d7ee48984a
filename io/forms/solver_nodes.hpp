#pragma once

#include <vector>

#include "mesher/plane/tile/midside_nodes.hpp"

namespace pcvt {

/// The nodes of a tile as solvers count them: its vertices and, where its order is 2, the nodes in
/// the middle of its edges behind them.
struct SolverNodes {
    /// One position a node, length units.
    std::vector<plane::Vec2> points;
    /// One pair for each node that is not the representative of its orbit, by rising w.
    std::vector<plane::VertexPair> pairs;
    /// Empty for order 1.
    plane::MidsideNodes middles;

    int n_nodes() const { return static_cast<int>(points.size()); }
};

SolverNodes solver_nodes(const plane::Tile& tile);

/// The nodes of face f: its corners, then, of order 2, the nodes between corner k and k + 1. This
/// is the order of Gmsh, VTK, Abaqus and CalculiX.
std::vector<int> element_nodes(const plane::Tile& tile, const SolverNodes& nodes, int f);

}  // namespace pcvt
