#pragma once

#include <span>
#include <vector>

#include "mesher/plane/mesh/periodic_mesh.hpp"
#include "mesher/plane/mesh/tile_options.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// Leaves the faces of some sites out of a tile, whose edges become walls with the names of the
/// holes; the edge of a hole that lies across the seam is one wall on both sides of it. Delaunay
/// triangles are left out if they have a corner at such a site.
///
/// Example usage:
///   Tile tile = with_holes(std::move(built.tile), {.names = {"fibre"}, .of_site = of_site});
///   for (const WallEdge& edge : tile.wall_edges) std::cout << wall_name(tile, edge.wall) << "\n";
///
/// Vertices, faces and sites that stay keep their order and are numbered from 0 again. Laws, tested
/// by number:
///   (1) Each boundary edge is in a pair, on a side of the domain, or on the edge of a hole.
///   (2) The tile with one more face for each hole is a tile of the torus (mesher/plane/proof
///   proves it). (3) The order of vertices and faces, and their positions, are those of the whole
///   tile.
/// @pre the tile obeys its laws, and a face stays.
/// @throws InvalidInput  Delaunay triangles between holes that are too near to each other.
Tile with_holes(Tile tile, const HoleSites& holes);

/// The same for a mesh of the torus: edges of holes have the opposite -1, as those on walls.
PeriodicMesh with_holes(PeriodicMesh mesh, const HoleSites& holes);

/// The holes of a tile as one list, for files without words: the number of names; of each name its
/// length and its characters; of each edge its hole and its two vertices. Empty without holes.
std::vector<double> holes_as_numbers(const Tile& tile);

/// Adds the holes of such a list to a tile without holes, which has its vertices.
/// @throws InvalidInput if the list does not have that form.
void take_holes(std::span<const double> numbers, Tile& tile);

}  // namespace pcvt::plane
