#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesher/base/error.hpp"
#include "mesher/base/workers.hpp"
#include "mesher/space/grains/grain_mesh.hpp"
#include "mesher/space/grains/sharp_features.hpp"

namespace pcvt::space {

/// How cells are filled with tetrahedra.
struct GrainChoices {
    /// The target length of edges, length units, as cell_sizes() takes it.
    double size = 0;
    /// Rounds in which the faces move together with the tetrahedra on both sides.
    int n_rounds = 2;
    /// Called with the part of the work that is done, in [0, 1]; may be empty.
    std::function<void(double)> progress = {};
};

/// Tetrahedra inside of cells.
struct Grains {
    GrainMesh mesh;
    std::vector<SharpFeature> sharp_features = {};
    /// The dihedral angles of the tetrahedra without a corner on a sharp feature
    /// (SharpFeatures::near), and of the others.
    DihedralRange angles = {};
    DihedralRange angles_at_features = {};
};

/// A cell has no point that sees its whole boundary.
class FoldedCell : public LimitExceeded {
   public:
    explicit FoldedCell(SiteId site)
        : LimitExceeded("the cell of site " + std::to_string(site) +
                        " has no point from which all its faces are visible; remove shorter edges "
                        "or none, or move the origin of the box") {}
};

/// A cell has a face so narrow that a tetrahedron beside it is flat.
class NarrowFeature : public LimitExceeded {
   public:
    explicit NarrowFeature(SiteId site)
        : LimitExceeded("the cell of site " + std::to_string(site) +
                        " has a face so narrow that a tetrahedron beside it would be flat; remove "
                        "short edges if the volumes need not be exact, move the site, or move the "
                        "origin of the box") {}
};

/// Fills each cell with tetrahedra: triangulates each face once (grain_surface.hpp), fills the
/// cells between these triangles one by one (cell_filling.hpp), and improves faces and cells
/// together (shared_moves.hpp).
///
/// Example usage:
///     const Grains grains = mesh_grains(sites, complex, {.size = sites.spacing() / 3}, workers);
///     const TetrahedralProof proof = prove_tetrahedra(grains.mesh.tetrahedra);
///
/// Laws, tested by number:
///   (1) The laws of GrainMesh hold for every lattice and for the power cells of any weights.
///   (2) With cells of a converged CVT and edges of a third of their spacing, dihedral angles are
///       at least 18 degrees where no face has a corner below 8 degrees, and 99 % are above 27.
///   (3) The bytes do not depend on the number of threads.
/// Cost: proportional to the number of tetrahedra, some 20 microseconds each.
///
/// @param complex  Voronoi cells or power cells, also without their short edges.
/// @param origin   the corner of the domain, length units.
/// @throws FoldedCell, NarrowFeature
Grains mesh_grains(const Sites& sites, const CellComplex& complex, const GrainChoices& choices,
                   Workers& workers, const Vec3& origin = Vec3::Zero());

}  // namespace pcvt::space
