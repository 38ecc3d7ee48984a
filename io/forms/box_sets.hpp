#pragma once

#include <string>
#include <vector>

#include "io/forms/element_mesh.hpp"

namespace pcvt {

/// The nodes of one side, edge or corner of a box.
struct BoxSet {
    std::string name;
    std::vector<int> nodes;
};

/// Returns the nodes on the boundary of a box in space, each in one set: `side_I_J_K` has those
/// that lie on one side alone, `edge_I_J_K` and `corner_I_J_K` those on two and on three. The
/// translation I a + J b + K c, with I, J, K from -1 to 1, takes the set to that of the opposite
/// part.
///
/// Laws, tested by number:
///   (1) Each node with a partner is in exactly one set.
///   (2) Node k of a set and node k of each set of its orbits, which are the sets of as many of the
///       same numbers that are not 0, are images of one node.
///
/// @returns nothing for a tile that is not glued like a box: an orbit has other than 1, 2, 4 or 8
/// nodes, or translations along one period vector do not connect them.
std::vector<BoxSet> box_sets(const ElementMesh& mesh);

}  // namespace pcvt
