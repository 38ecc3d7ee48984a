#pragma once

#include <span>

#include "mesher/plane/proof/moved_cells.hpp"
#include "mesher/plane/proof/validate.hpp"

namespace pcvt::plane {

/// Proves the site ids of a proven tile: that its faces, or its vertices, belong to the sites that
/// they name. A tile without ids passes.
///
/// Example usage:
///   const TileProof proof = prove_tile(tile, Precision::kDouble);
///   prove_sites(tile, proof);
///
///   (1) The ids are 0 ... n - 1, and each of them occurs.
///   (2) Delaunay triangles: all vertices of an orbit have one id, and each id has as many orbits
///       as every other one, `columns` x `rows` where the tile states them.
///   (3) Cells and grains of a tile that states `columns` and `rows`: each id has at least one face
///       for each period.
///
/// Where the positions of the sites are known (Tile::site_positions, or those in memory), S is the
/// set of all images of the sites by the vectors i a / columns + j b / rows, and:
///   (4) The position of a site is in S with the zero vector at the first face (vertex) that names
///       it.
///   (5) Cells: each face belongs to the image of its site that is nearest to it, and each image
///       modulo the lattice has a face. Delaunay triangles: each vertex is an image of its site.
///   (6) Cells: a vertex is equally far from the sites of all its faces.
///
/// Where edges of cells were removed (Tile::short_edges, and always in grains), and with them (5)
/// and (6), these laws hold instead (moved_cells.hpp):
///   (7) A vertex at which k > 2 cells meet lies at the mean of the circumcentres of the k - 2
///       Delaunay triangles of their sites (dual_mean.hpp). In grains with a box outline, a vertex
///       on a side of the box may have been moved onto it along a period vector, by less than 0.04
///       h from the side, and at a corner of the box freely by 0.04 h.
///   (8) Where two cells meet, the edge between them is straight, but for the corners of the box.
///   (9) The faces of a site form no more parts than the tile has periods.
/// At the edges of holes no corner is moved: law (6) holds there. The sites of holes have no id.
/// They need no bound for the distance by which corners were moved. Tile::short_edges matters
/// only where a cell touches another image of itself.
///
/// With weights (Tile::site_weights), "equally far" means an equal power distance |p - x|^2 - w;
/// distances are those of Tile::metric.
///
/// For a tile with walls these are laws of the tile together with its mirror images.
///
/// By (4) to (9), two ids that are exchanged are found, and a site that moves. Distances are
/// compared within 1e-7 h + 8 proof.tolerance, h = sqrt(area / number of cells). Where one of the
/// sites round a vertex at a distance of r has another site at a distance of d < r, the tolerance
/// of positions counts r / d times. Cost: O(n) and O(n) more for each such vertex.
/// @returns the cell of each face if corners were moved; else an empty result, which is clear.
/// @throws NotATile naming the site and the face or the vertex.
FaceImages prove_sites(const Tile& tile, const TileProof& proof);

/// Proves that the cells of each orbit of sites have one area, which the symmetry gives them,
/// within 1e-6. Triangles, and cells without their short edges, need not have it.
///
/// Example usage:
///   prove_orbit_areas(tile, prove_tile(tile, Precision::kDouble), {0, 1, 1, 0});
///
/// @param site_orbits  one a site, counted in the order of the sites.
/// @throws NotATile naming two sites of one orbit.
void prove_orbit_areas(const Tile& tile, const TileProof& proof, std::span<const int> site_orbits);

}  // namespace pcvt::plane
