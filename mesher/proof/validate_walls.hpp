#pragma once

#include "mesher/proof/glued_faces.hpp"
#include "mesher/proof/validate.hpp"

namespace pcvt {

/// What laws (1) and (2) of prove_tile() give.
struct Gluing {
    TileProof proof{};
    GluedFaces faces;
};

/// 4 ulps of the largest coordinate.
double position_tolerance(const Tile& tile, Precision precision);

/// Proves law (6).
/// @throws NotATile naming the vertex and the wall.
void require_between_walls(const Tile& tile, Precision precision);

/// The tile with its vertices and sites on walls exactly there, from where single precision moves
/// them.
Tile with_exact_walls(Tile tile, double tolerance);

/// The part of a gluing of mirrored_tile(tile) that belongs to the tile. Edges on walls are their
/// own opposites, and their `across` is not 0.
///
/// Example usage:
///   const Gluing part = part_of_tile(channel, glued(mirrored_tile(channel), precision));
///   const std::vector<WallEdge>& walls = part.proof.wall_edges;
Gluing part_of_tile(const Tile& tile, const Gluing& torus);

}  // namespace pcvt
