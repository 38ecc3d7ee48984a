#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/cells/finite_volume_mesh.hpp"
#include "mesher/finite_volume/cell_flow.hpp"

namespace pcvt {

/// The cells of a case: one layer of prisms over a tile of the plane, or polyhedra.
enum class FoamCells { kLayer, kPolyhedra };

/// Cells with a name.
struct FoamZone {
    std::string name;
    std::vector<int> cells;
};

/// All that the files of an OpenFOAM case state, in the plane and in space: writers encode it, and
/// tiles become one (foam_layer.hpp, foam_polyhedra.hpp).
///
/// Example usage:
///     const FiniteVolumeMesh layer = extruded_mesh(tile);
///     const FoamCase foam = foam_case(tile, layer);
///     const std::vector<EncodedFile> files = encode_foam(foam, "tile.foam");
struct FoamCase {
    FoamCells cells;
    /// Must outlive the case.
    const FiniteVolumeMesh& mesh;
    CellFlow flow;
    /// The comments in the boundary file, from foam_notes() on.
    std::string notes;
    /// The zones of the phases.
    std::vector<FoamZone> zones = {};
};

/// "seam_I_J", or "seam_I_J_K" for three periods: the form of the names of cyclic patches.
std::string foam_seam_form(Eigen::Index n_periods);

/// Returns the comment by which a case states its kind: "voronoi", "polyhedra", ...
std::string foam_kind_note(std::string_view kind);

/// Returns the first comments of a boundary file: its kind, and its periods, one a column.
std::string foam_notes(std::string_view kind, const Eigen::MatrixXd& periods);

}  // namespace pcvt
