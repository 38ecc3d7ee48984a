#pragma once

#include <vector>

#include "mesher/base/law_violation.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// The precision in which a tile's coordinates were stored.
enum class Precision { kDouble, kSingle };

/// The name of law (1) of prove_tile() in messages.
inline constexpr const char* kFaceLaw = "(1), faces";

/// The result of prove_tile, derived only from positions, faces and the lattice.
struct TileProof {
    int n_vertices;        ///< distinct vertices of the tile, after merging
    int n_merged;          ///< vertices of the file that fell onto another one
    int n_faces;           ///< faces of positive size
    int n_boundary_edges;  ///< before gluing
    int n_orbits;          ///< vertices after gluing
    double area;           ///< sum of the face areas, length^2
    double tolerance;      ///< length units, 4 ulps of the largest coordinate or more
    double mismatch;       ///< the largest one of a vertex and its image, in one coordinate
    /// For each vertex of the file, the first vertex that coincides with it, usually itself.
    std::vector<int> first_copy;
    /// As in Tile, between first copies.
    std::vector<VertexPair> vertex_pairs;
    /// Sorted; each pair is stored from the side with the positive offset (i, j):
    /// i > 0, or i = 0 and j > 0.
    std::vector<EdgePair> edge_pairs;
    /// Sorted, as Tile::wall_edges.
    std::vector<WallEdge> wall_edges;
    Precision precision;
};

/// Proves that `tile` is a tile of its lattice, from positions, faces and lattice; the stored pairs
/// are ignored.
///
/// Example usage:
///   const TileProof proof = prove_tile(tile, Precision::kDouble);
///   compare_vertex_pairs(tile, proof);
///   compare_edge_pairs(tile, proof);
///   const double distance = prove_voronoi(tile, proof, 1e-6);
///
///   (1) Every coordinate is finite, every vertex belongs to a face, and every face is a simple
///       polygon of three distinct corners or more with positive area.
///   (2) Each boundary edge has exactly one reversed partner by exactly one lattice vector, not 0.
///   (3) The tile is a disc: one boundary loop, one fan of faces around each vertex, V - E + F = 1.
///   (4) V - E + F = 0 after gluing.
///   (5) The areas of the faces sum to the area of the fundamental domain.
///   (6) The vertices of a tile with walls lie between them, or on them: to the last bit in double
///       precision.
///   (7) The edges of holes form loops. Each loop has one name and is a simple polygon that does
///       not go round the torus.
///
/// In a tile with holes, an edge may be that of a hole instead of having a partner (2); the faces
/// are connected over edges and the seam (3); V - E + F = -k for k loops (4); the areas of the
/// faces and of the holes' polygons have the sum (5). Which edges lie at holes is read from
/// Tile::wall_edges, everything else from positions.
///
/// For a tile with walls, laws (2), (4) and (5) are those of the tile together with its mirror
/// images (validate_walls.hpp), and law (3) is that of the tile. An edge whose partner belongs to
/// an image is a wall edge. The walls are therefore straight and complete, and the tile is an
/// annulus after gluing, or with four walls a disc.
///
/// Together the laws prove that the faces cover the torus exactly once: by (1) to (4) the glued
/// faces cover every point equally often, and by (5) once.
///
/// Positions are compared coordinate by coordinate within position_tolerance() of the given
/// precision. Vertices that coincide modulo the lattice within this tolerance, directly or by a
/// chain, are one vertex. In double precision two vertices of one tile must not coincide. In single
/// precision coincident vertices are merged, edges of length zero and faces with fewer than three
/// remaining corners are dropped, and an area may be negative by at most tolerance times perimeter.
/// Cost: O(n log n), plus the square of the number of corners for each non-convex face.
/// @param least_tolerance  of positions, length units: of files of other programs, whose sides
/// agree
///                         less closely than 4 ulps.
/// @throws NotATile naming the law, the vertex or face (from 0), and the measured amount; as
///         SeamMismatch where a wider tolerance may help.
TileProof prove_tile(const Tile& tile, Precision precision, double least_tolerance = 0);

/// Compares the stored pairs with the proven ones as sets of identifications: the vertex pairs may
/// be any generating set, and an edge pair may be stored from either side.
/// @throws NotATile naming the first stored pair that is wrong, or the first that is missing.
void compare_vertex_pairs(const Tile& tile, const TileProof& proof);
void compare_edge_pairs(const Tile& tile, const TileProof& proof);

/// Compares the stored edges on walls with the proven ones: an edge of a hole has no face beyond.
/// @throws NotATile naming the first one that is wrong or missing.
void compare_wall_edges(const Tile& tile, const TileProof& proof);

/// Proves laws (1), (2), (4) and (5) of a tile without walls; its faces need not form a disc.
TileProof prove_cover(const Tile& tile, Precision precision);

/// For cells, proves that each cell is the Voronoi cell of its own centroid among all images of all
/// centroids, so the tile is a centroidal Voronoi tessellation: every cell is convex, and every
/// edge lies on the bisector of the two adjacent centroids. For triangles, proves that each edge is
/// locally Delaunay. Both local laws imply the global property.
///
/// With weights (Tile::site_weights), which power cells have, it proves that each site lies at the
/// centroid of its cell, and of triangles that each edge is locally regular: no corner lies inside
/// the power circle of a triangle beside its own, the circle of equal power distance from the
/// corners of that triangle. Elongated cells are proved in their metric (Tile::metric), in which h
/// is the same.
///
/// In a tile between walls, a cell whose site lies on a wall consists of a face and its mirror
/// image; its centroid lies on the wall. So does that of four faces in a corner. The tile must have
/// the positions of its sites.
///
/// A cell is a face or a fan of consecutive triangles that have the same face_site and the same
/// first corner and share an edge with their predecessor. Cells must be whole: the pieces of a cell
/// that an outline has cut are refused like any other face that is not a Voronoi cell.
/// @param proof      the result of prove_tile for this tile.
/// @param tolerance  cells: the largest distance of a corner from the bisector on which it should
///                   lie, with weights of a site from the centroid; triangles: the largest depth of
///                   an opposite corner in a circumcircle or a power circle; in units of
///                   h = sqrt(area / number of cells or of vertex orbits).
/// @pre prove_sites() accepts a tile with weights.
/// @returns the largest such distance or depth found, in units of h; 0 if no corner lies inside a
///          circumcircle.
/// @throws NotATile naming the face and the amount.
/// @throws InvalidInput for grains.
double prove_voronoi(const Tile& tile, const TileProof& proof, double tolerance);

}  // namespace pcvt::plane
