#pragma once

#include <optional>
#include <vector>

#include "mesher/plane/tile/midside_nodes.hpp"

namespace pcvt {

/// A longest stretch of a tile's boundary that one translation takes to its partners, or that lies
/// on one wall.
struct SeamSegment {
    /// Takes the run to its partner: position + translation(offset). On a wall: (0, 0).
    plane::Offset offset;
    /// Along the boundary, the tile on the left; both ends included, so two or more.
    std::vector<int> vertices;
    /// For order 2 the nodes between them: middles[k] after vertices[k].
    std::vector<int> middles;
    /// Index of the run that it is glued to, which runs the other way: vertex k of this one and
    /// vertex size - 1 - k of that one are partners, likewise the middles.
    /// On a wall: -1.
    int partner;
    /// The wall on which the run lies; nothing on the seam.
    std::optional<plane::WallId> wall = {};
};

/// The boundary as runs, with the tile on their left: loop by loop from the smallest vertex where a
/// run begins. In a loop each run begins where the one before ends. Laws, tested by number:
///
///   (1) The partner of a partner is the run itself, with the opposite offset; runs on walls have
///       none.
///   (2) Every boundary edge lies in one run; a run's neighbours have another offset or wall than
///       it has, but for (3), for vertices at which two parts of a tile with holes meet, and for
///       loops of one run.
///   (3) The ends of runs are closed under identification: a vertex on the orbit of an end is one.
///
/// @param middles  of a tile of order 2; else empty.
/// @pre the tile has its edge_pairs and its wall_edges.
/// @throws InternalError where they do not form loops.
std::vector<SeamSegment> seam_segments(const plane::Tile& tile, const plane::MidsideNodes& middles);

}  // namespace pcvt
