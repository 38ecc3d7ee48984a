#pragma once

#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt::space {

/// Figures that the proof of a polyhedral mesh finds.
struct PolyhedralProof {
    int n_cells = 0;
    int n_faces = 0;
    int n_boundary_pairs = 0;
    /// The number of translations of the seam, counted once for both directions.
    int n_translations = 0;
    double volume = 0;
    /// The tolerance of positions, and the largest distance of a point from its representative plus
    /// the translation, in one coordinate; length units.
    double tolerance = 0;
    double mismatch = 0;
    /// Whether each edge of the boundary belongs to two boundary faces, and the boundary faces at
    /// each point are one fan.
    bool boundary_is_manifold = false;
};

/// Proves the laws of PolyhedralMesh from only positions and period vectors: the pairs of boundary
/// faces are found again from their positions and then compared with the patches. Positions may
/// differ by 4 double ulps of the largest coordinate.
///
/// Example usage:
///   const PolyhedralProof proof = prove_polyhedra(mesh);
///
/// @param least_tolerance  of positions, length units: of files of other programs.
/// @throws NotATile with the law and the first faces that break it.
PolyhedralProof prove_polyhedra(const PolyhedralMesh& mesh, double least_tolerance = 0);

}  // namespace pcvt::space
