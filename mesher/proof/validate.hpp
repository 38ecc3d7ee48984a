#pragma once

#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// The precision in which a tile's coordinates were stored.
enum class Precision { kDouble, kSingle };

/// A tile breaks one of its laws; the message says which, where, and by how much.
class NotATile : public InvalidInput {
   public:
    using InvalidInput::InvalidInput;
};

/// What prove_tile found out from positions and the lattice alone.
struct TileProof {
    int n_vertices;        ///< distinct vertices of the tile, after merging
    int n_merged;          ///< vertices of the file that fell onto another one
    int n_faces;           ///< faces of positive size
    int n_boundary_edges;  ///< before gluing
    int n_orbits;          ///< vertices after gluing
    double area;           ///< sum of the face areas, length^2
    double tolerance;      ///< length units, 4 ulps of the largest coordinate
    /// For each vertex of the file the first one that coincides with it: most often itself.
    std::vector<int> first_copy;
    /// As in Tile, between first copies.
    std::vector<VertexPair> vertex_pairs;
    /// Sorted; each pair told from the side whose offset is positive: i > 0, or i = 0 and j > 0.
    std::vector<EdgePair> edge_pairs;
};

/// Proves that `tile` is a tile of its lattice, from positions, faces and lattice alone: the stored
/// pairs are not looked at.
///
///   (1) Every coordinate is finite, every vertex belongs to a face, and every face is a simple
///       polygon of three distinct corners or more with positive area.
///   (2) Each boundary edge has exactly one reversed partner by exactly one lattice vector, not 0.
///   (3) The tile is a disc: one boundary loop, one fan of faces round each vertex, V - E + F = 1.
///   (4) V - E + F = 0 after gluing.
///   (5) The areas of the faces sum to the area of the fundamental domain.
///
/// Together they prove that the faces cover the torus exactly once: by (1) to (4) the glued faces
/// cover it equally often everywhere, by (5) once.
///
/// Positions are compared in each coordinate within 4 ulps of the largest one, in the precision
/// stated. Vertices that coincide modulo the lattice within this tolerance, directly or by a chain,
/// are one vertex. In double precision two vertices of one tile must not coincide. In single
/// precision they are merged: edges that shrink to a point and faces that shrink to less than a
/// triangle are dropped, and an area may be negative by tolerance times perimeter.
/// Cost: O(n log n); a face that is not convex costs the square of its corners.
/// @throws NotATile naming the law, the vertex or face (from 0), and the measured amount.
TileProof prove_tile(const Tile& tile, Precision precision);

/// Compares stored pairs with the proven ones, as sets of identifications: vertex pairs may be any
/// that generate them, and an edge pair may be told from either side.
/// @throws NotATile naming the first stored pair that is wrong, or the first that is missing.
void compare_vertex_pairs(const Tile& tile, const TileProof& proof);
void compare_edge_pairs(const Tile& tile, const TileProof& proof);

/// Cells: proves that each cell is the Voronoi cell of its own centroid among all images of all
/// centroids, i.e. that the tile is a centroidal Voronoi tessellation: every cell is convex, and
/// every edge lies on the bisector of the two centroids beside it. Triangles: that each edge is
/// locally Delaunay. Both are local laws that imply the global one.
///
/// A cell is a face, or a fan: consecutive triangles with one face_site and one first corner, each
/// sharing an edge with the one before. Cells must be whole: the pieces of a cell that an outline
/// has cut are refused like any other face that is no Voronoi cell.
/// @param proof      what prove_tile returned for this tile.
/// @param tolerance  cells: the largest distance of a corner to the bisector that it should lie
///                   on; triangles: of the opposite corner into the circumcircle; in units of
///                   h = sqrt(area / number of cells or of vertex orbits).
/// @returns the largest such distance found, in units of h; 0 where no corner lies inside.
/// @throws NotATile naming the face and the amount.
/// @throws InvalidInput for grains.
double prove_voronoi(const Tile& tile, const TileProof& proof, double tolerance);

}  // namespace pcvt
