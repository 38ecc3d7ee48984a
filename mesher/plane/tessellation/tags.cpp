#include "mesher/plane/tessellation/tags.hpp"

#include <algorithm>

namespace pcvt::plane {

CellMaterials tag_materials(const Tessellation& tessellation) {
    const HoleSites& holes = tessellation.holes;
    if (holes.empty()) {
        return {.phase_names = tessellation.tag_names, .site_phase = tessellation.site_tags};
    }
    CellMaterials materials;
    std::vector<int> phase_of_tag;
    for (const std::string& name : tessellation.tag_names) {
        const bool is_hole =
            std::find(holes.names.begin(), holes.names.end(), name) != holes.names.end();
        phase_of_tag.push_back(is_hole ? -1 : static_cast<int>(materials.phase_names.size()));
        if (!is_hole) materials.phase_names.push_back(name);
    }
    for (const SiteId s : holes.kept()) {
        materials.site_phase.push_back(phase_of_tag[tessellation.site_tags[s]]);
    }
    return materials;
}

std::vector<PhaseFigures> tag_figures(const Tessellation& tessellation) {
    MaterialChoices tags;
    for (std::size_t k = 0; k < tessellation.tag_names.size(); ++k) {
        const double share = tessellation.tag_areas[k] / tessellation.lattice().area();
        tags.phases.push_back({tessellation.tag_names[k], share});
    }
    const CellMaterials of_all{.phase_names = tessellation.tag_names,
                               .site_phase = tessellation.site_tags};
    return phase_figures(tags, of_all, tessellation.table());
}

MaterialsOfCells materials_of_sites(const Tessellation& tessellation,
                                    const MaterialChoices& choices, std::uint64_t seed) {
    if (!tessellation.tag_names.empty()) {
        return {tag_materials(tessellation), tag_figures(tessellation)};
    }
    if (choices.empty()) return {};
    return materials_of_cells(choices, tessellation.table(), seed);
}

}  // namespace pcvt::plane
