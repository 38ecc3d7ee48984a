#include "io/solvers/msh_model.hpp"

namespace pcvt {

MshModel msh_model(const plane::Tile& tile, const SolverNodes& nodes,
                   const CellMaterials* materials) {
    MshModel model{.entities = msh_entities(tile, nodes),
                   .point_tag = std::vector<int>(tile.points.size(), 0)};
    if (materials != nullptr) {
        model.materials.phase_names = materials->phase_names;
        model.materials.site_phase = materials->site_phase;
    }
    for (std::size_t k = 0; k < model.entities.points.size(); ++k) {
        model.point_tag[model.entities.points[k]] = static_cast<int>(k) + 1;
    }
    for (const MshCurve& curve : model.entities.curves) {
        if (curve.is_seam()) model.seam_groups[curve.offset] = 0;
        if (curve.wall) model.wall_groups[*curve.wall] = 0;
    }
    model.has_boundary = !model.entities.curves.back().bounds_tile();
    int tag = model.entities.surfaces.back().site + 1;
    for (auto& [offset, group] : model.seam_groups) group = ++tag;
    for (auto& [wall, group] : model.wall_groups) group = ++tag;
    model.boundary_group = tag + 1;
    model.phase_group = tag + 2;
    if (!model.materials.empty()) {
        for (const MshSurface& cell : model.entities.surfaces) {
            model.phases.insert(model.materials.site_phase[cell.site]);
        }
    }
    return model;
}

}  // namespace pcvt
