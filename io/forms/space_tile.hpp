#pragma once

#include "mesher/cells/cell_materials.hpp"
#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt {

/// A tile of polyhedra and its sites, as files hold them.
struct SpaceTile {
    space::PolyhedralMesh mesh;
    /// The image of each site that its cell belongs to: 3 x n, length units; no column if a file
    /// states none. A Voronoi cell contains it, a power cell may lie beside it.
    space::Points sites = space::Points(3, 0);
    /// The weight of each site, length^2; empty for Voronoi cells.
    Eigen::VectorXd weights = {};
    /// The materials of the cells, where the run has some and a format states them.
    CellMaterials materials = {};
};

/// The complaint about a file in which PolyhedralMesh::short_edges is out of its range.
inline constexpr const char* kShortEdgesRange =
    "the length of removed edges is not one number from 0 to 0.1; write the file again with pcvt";

}  // namespace pcvt
