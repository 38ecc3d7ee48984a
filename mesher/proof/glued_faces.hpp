#pragma once

#include "mesher/proof/validate.hpp"
#include "mesher/proof/vertex_orbits.hpp"

namespace pcvt {

/// The faces of a tile on proven vertices, each side with the one that runs the other way along it.
///
/// A halfedge is the index of the corner that it leaves.
struct GluedFaces {
    /// The number of each face in the file: faces that shrank to less than a triangle are left out.
    std::vector<int> file_face;
    std::vector<int> face_begin;
    /// Vertex indices; of vertices that coincide the first one.
    std::vector<int> corners;
    std::vector<int> face_of;
    /// The halfedge across: inside of the tile or over the seam; an involution.
    std::vector<int> opposite;
    /// The opposite halfedge lies on this one + translation: (0, 0) inside of the tile.
    std::vector<Offset> across;

    int n_faces() const { return static_cast<int>(file_face.size()); }
    int n_halfedges() const { return static_cast<int>(corners.size()); }
    int next(int h) const {
        return h + 1 == face_begin[face_of[h] + 1] ? face_begin[face_of[h]] : h + 1;
    }
    bool on_seam(int h) const { return across[h] != Offset{}; }
};

/// Drops corners that coincide with the one before and faces that have fewer than three left, then
/// matches the sides of the faces by orbits and offsets. In double precision nothing may be
/// dropped.
/// @throws NotATile where a face meets a vertex twice, or a side has not exactly one partner.
GluedFaces glue_faces(const Tile& tile, const VertexOrbits& orbits, Precision precision);

}  // namespace pcvt
