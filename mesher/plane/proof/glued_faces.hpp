#pragma once

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/plane/proof/vertex_orbits.hpp"

namespace pcvt::plane {

/// The faces of a tile on proven vertices; each side is linked to the opposite side of its edge.
///
/// Example usage:
///   const GluedFaces faces = glue_faces(tile, proven_orbits(proof), Precision::kDouble);
///   const int neighbour = faces.face_of[faces.opposite[h]];
///
/// A halfedge has the index of the corner that it leaves. Corners are vertex indices; coincident
/// vertices are replaced by the first of them.
struct GluedFaces : Faces {
    /// The index of each face in the file. Faces with fewer than three distinct corners are left
    /// out.
    std::vector<int> file_face;
    std::vector<int> face_of;
    /// The halfedge on the other side of the edge, inside the tile or across the seam; an
    /// involution.
    std::vector<int> opposite;
    /// The opposite halfedge is this one plus the translation; (0, 0) inside the tile. Edges on
    /// walls are their own opposites, and their `across` is (1, 1).
    std::vector<Offset> across;
    /// The halfedges on the edges of holes, sorted, on the first copies of vertices.
    std::vector<WallEdge> hole_edges = {};

    int n_halfedges() const { return static_cast<int>(corners.size()); }
    int next(int h) const { return h + 1 == begin[face_of[h] + 1] ? begin[face_of[h]] : h + 1; }
    int previous(int h) const { return h == begin[face_of[h]] ? begin[face_of[h] + 1] - 1 : h - 1; }
    /// Whether h is on the boundary of the tile: on its seam or on a wall.
    bool on_seam(int h) const { return across[h] != Offset{}; }
    bool on_wall(int h) const { return opposite[h] == h; }
    void put_on_wall(int h) {
        opposite[h] = h;
        across[h] = {1, 1};
    }
};

/// Drops corners that coincide with the preceding corner and faces with fewer than three remaining
/// corners, then matches the sides of the faces by orbits and offsets. In double precision nothing
/// may be dropped. A side without a partner that the tile names as the edge of a hole is on a wall.
/// @throws NotATile if a face meets a vertex twice, or another side does not have exactly one
/// partner.
GluedFaces glue_faces(const Tile& tile, const VertexOrbits& orbits, Precision precision);

}  // namespace pcvt::plane
