#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// A run of boundary faces of an extruded mesh: one side of a seam, a wall, the back or the front.
struct ExtrudedPatch {
    /// "seam_I_J", the name of a wall or a hole, or "back" (z = 0) and "front".
    std::string name;
    int first_face;
    int n_faces;
    /// The patch whose face i matches face i of this patch; -1 for the others.
    int partner;
    /// (I, J): the partner's faces are the faces of this patch plus the translation.
    plane::Offset offset;
    /// The stored value of that translation, length units.
    plane::Vec2 separation;
    /// Of walls and holes. Holes are counted in the order of their patches.
    std::optional<plane::WallId> wall = {};
};

/// A tile extruded to one layer of prisms, with faces in the order that finite-volume solvers
/// require.
///
/// Laws, tested by number:
///   (1) The first half of the points lies at z = 0, and point v is vertex v of the tile. Point v +
///       V of the second half lies above it at z = thickness. Cell f is the prism over face f.
///   (2) Inner faces come first, with owner < neighbour, sorted by (owner, neighbour); their normal
///       points out of the owner. Boundary faces follow, patch by patch; their normal points out of
///       the mesh.
///   (3) Each patch of a seam matches its partner face by face, and point by point if one face is
///       traversed forwards and the other backwards from its first point.
///   (4) Each wall of the tile is one patch with its name, and so are the holes of one name. Its
///       faces are those above the edges on that wall.
struct ExtrudedMesh {
    plane::Lattice lattice;
    plane::MeshKind kind;
    /// Positions, length units.
    std::vector<Eigen::Vector3d> points = {};
    /// On these points.
    Faces faces = {};
    /// The cell behind each face, and the cell in front of each inner face.
    std::vector<int> owner = {};
    std::vector<int> neighbour = {};
    std::vector<ExtrudedPatch> patches = {};

    int n_points() const { return static_cast<int>(points.size()); }
    int n_faces() const { return static_cast<int>(owner.size()); }
    int n_inner_faces() const { return static_cast<int>(neighbour.size()); }
    int face_size(int f) const { return faces.size(f); }
};

/// Extrudes `tile` by `thickness`; 0: by one mean spacing sqrt(area / n_faces).
///
/// Example usage:
///   const ExtrudedMesh extruded = extruded_mesh(tile);
///   for (const ExtrudedPatch& patch : extruded.patches) std::cout << patch.name << "\n";
///
/// The seam becomes one pair of patches per translation, "seam_I_J" before "seam_-I_-J", where (I,
/// J) > 0. The patches of the walls follow in the order of kWallSides, then those of the holes in
/// the order of Tile::holes, then "back" and "front".
ExtrudedMesh extruded_mesh(const plane::Tile& tile, double thickness = 0);

}  // namespace pcvt
