#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <vector>

#include "mesher/base/faces.hpp"

namespace pcvt {

/// One side of a seam, a wall, or a side across which nothing is solved.
enum class PatchKind { kCyclic, kWall, kEmpty };

/// A run of boundary faces of a finite-volume mesh.
struct FiniteVolumePatch {
    /// The name in files; for a cyclic patch, seam_name() of its offset (set_names.hpp).
    std::string name;
    PatchKind kind;
    int first_face;
    int n_faces;
    /// The patch whose face i matches face i of this patch; -1 where the patch is not cyclic.
    int partner = -1;
    /// (I, J) or (I, J, K): the faces of the partner are those of this patch plus the translation.
    /// As many numbers as the lattice has periods; empty where the patch is not cyclic.
    std::vector<int> offset = {};
    /// That translation, length units.
    Eigen::Vector3d separation = Eigen::Vector3d::Zero();

    int end_face() const { return first_face + n_faces; }
    /// The offset in the plane or in space; numbers that are missing are 0.
    template <class Offset>
    Offset offset_as() const {
        auto numbers = Offset{}.components();
        std::copy_n(offset.begin(), std::min(offset.size(), numbers.size()), numbers.begin());
        return Offset::of(numbers);
    }
};

/// Cells as finite-volume solvers take them, in the plane (one layer of prisms) and in space:
/// points, faces with the cells on both sides, and patches of boundary faces.
///
/// Inner faces come first, with owner < neighbour, sorted by (owner, neighbour). Boundary faces
/// follow, patch by patch. The faces of a cyclic patch match those of its partner point by point if
/// one face is traversed forwards and the other backwards from its first point. Which way a face
/// runs, and the other laws, are those of extruded_mesh() and of PolyhedralMesh.
///
/// Example usage:
///     for (const FiniteVolumePatch& patch : mesh.patches) {
///         for (int f = patch.first_face; f < patch.end_face(); ++f) visit(mesh.owner[f]);
///     }
struct FiniteVolumeMesh {
    /// Positions, length units.
    std::vector<Eigen::Vector3d> points = {};
    /// On these points.
    Faces faces = {};
    /// The cell behind each face, and the cell in front of each inner face.
    std::vector<int> owner = {};
    std::vector<int> neighbour = {};
    std::vector<FiniteVolumePatch> patches = {};
    int n_cells = 0;

    int n_points() const { return static_cast<int>(points.size()); }
    int n_faces() const { return static_cast<int>(owner.size()); }
    int n_inner_faces() const { return static_cast<int>(neighbour.size()); }
};

/// Returns the largest cell that the faces name; -1 if they name none.
int last_cell(const FiniteVolumeMesh& mesh);

/// Adds the two patches of a seam, whose faces the next n_faces faces and the n_faces after them
/// are.
///
/// @param there, back  the translations of the first patch and of the second, length units.
void add_seam_patches(const std::vector<int>& offset, const Eigen::Vector3d& there,
                      const Eigen::Vector3d& back, int n_faces, FiniteVolumeMesh& mesh);

/// Requires that a mesh refers only to points and cells that exist, that its inner faces are in
/// order, and that its patches are one run of the boundary faces each, in their order.
/// @param law  the law of the order of faces, for the message.
/// @throws NotATile naming the face, the cell or the patch.
void require_face_order(const FiniteVolumeMesh& mesh, const char* law);

}  // namespace pcvt
