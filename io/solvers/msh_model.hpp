#pragma once

#include <map>
#include <set>
#include <vector>

#include "io/solvers/msh_entities.hpp"
#include "mesher/cells/cell_materials.hpp"

namespace pcvt {

/// The entities of a tile with their tags: point and curve k have the tag k + 1, the surface of a
/// cell has the tag site + 1. Tags of physical groups are distinct over the dimensions, because
/// GetDP has one list of groups for curves and surfaces: site + 1 again, then the curves, then the
/// phases.
///
/// Example usage:
///     const MshModel model = msh_model(tile, nodes, materials);
///     for (const MshSurface& cell : model.entities.surfaces) list(cell, model.groups(cell));
struct MshModel {
    /// Without phases: empty.
    CellMaterials materials = {};
    MshEntities entities;
    /// Of each vertex; 0 where there is no point.
    std::vector<int> point_tag;
    /// The physical group of all curves with one offset.
    std::map<plane::Offset, int> seam_groups = {};
    /// The physical group of all curves on one wall.
    std::map<plane::WallId, int> wall_groups = {};
    int boundary_group = 0;
    bool has_boundary = false;
    /// The group of the first phase.
    int phase_group = 0;
    /// The indices of the phases of all surfaces, rising.
    std::set<int> phases = {};

    int n_curves() const { return static_cast<int>(entities.curves.size()); }
    int group(const MshCurve& curve) const {
        if (curve.wall) return wall_groups.at(*curve.wall);
        return curve.is_seam() ? seam_groups.at(curve.offset) : boundary_group;
    }
    /// The physical groups of a surface: its cell and, where there are phases, its phase.
    std::vector<int> groups(const MshSurface& cell) const {
        std::vector<int> groups{cell.site + 1};
        if (!phases.empty()) groups.push_back(phase_group + materials.site_phase[cell.site]);
        return groups;
    }
};

/// @param nodes      solver_nodes() of the tile.
/// @param materials  null: no phases.
MshModel msh_model(const plane::Tile& tile, const SolverNodes& nodes,
                   const CellMaterials* materials);

}  // namespace pcvt
