#pragma once

#include <string>
#include <vector>

#include "mesher/tile/tile.hpp"

namespace pcvt {

/// A run of boundary faces of a extruded: one side of a seam, or its back or front.
struct ExtrudedPatch {
    /// "seam_I_J", or "back" (z = 0) and "front".
    std::string name;
    int first_face;
    int n_faces;
    /// The patch whose face i answers face i of this one; -1 for back and front.
    int partner;
    /// (I, J): the answering faces lie on these + translation.
    Offset offset;
    /// That translation as it is stored, length units.
    Vec2 separation;
};

/// A tile pulled up into one layer of prisms, with faces in the order that finite volumes want.
///
/// Laws, tested by number:
///   (1) The first half of the points lies at z = 0, vertex v of the tile at v; point v + V of the
///       second half stands above it at z = thickness. Cell f is the prism over face f.
///   (2) Inner faces come first, owner < neighbour, sorted by (owner, neighbour); their normal
///       leaves the owner. Boundary faces follow, patch by patch; their normal leaves the extruded.
///   (3) Each patch of a seam is answered by its partner face by face, and point by point when the
///       one is walked through forwards and the other backwards from its first point.
struct ExtrudedMesh {
    Lattice lattice;
    MeshKind kind;
    /// Length units.
    std::vector<Eigen::Vector3d> points;
    /// Face f has the points corners[face_begin[f]] ... corners[face_begin[f + 1] - 1].
    std::vector<int> face_begin{0};
    std::vector<int> corners;
    /// The cell behind each face; for the inner faces the one in front as well.
    std::vector<int> owner;
    std::vector<int> neighbour;
    std::vector<ExtrudedPatch> patches;

    int n_points() const { return static_cast<int>(points.size()); }
    int n_faces() const { return static_cast<int>(owner.size()); }
    int n_inner_faces() const { return static_cast<int>(neighbour.size()); }
    int face_size(int f) const { return face_begin[f + 1] - face_begin[f]; }
};

/// The extruded over `tile`, one mean spacing sqrt(area / n_faces) thick.
///
/// The seam becomes a pair of patches for each translation, "seam_I_J" before "seam_-I_-J" where
/// (I, J) > 0; then "back" and "front".
ExtrudedMesh extruded_mesh(const Tile& tile);

}  // namespace pcvt
