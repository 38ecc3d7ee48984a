#include "mesher/cells/material_choices.hpp"

#include <algorithm>

#include "mesher/base/error.hpp"
#include "mesher/cells/orientations.hpp"
#include "mesher/cells/phase_assignment.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

std::vector<BungeAngles> choose_orientations(const MaterialChoices& choices, int n_cells,
                                             std::uint64_t seed) {
    if (choices.draws_orientations) return random_orientations(n_cells, seed);
    if (!choices.draws_from_list(n_cells)) return choices.orientations;
    std::vector<double> weights = choices.orientation_weights;
    if (weights.empty()) weights.assign(choices.orientations.size(), 1);
    std::vector<BungeAngles> chosen;
    for (const int k : draw_entries(weights, n_cells, seed)) {
        chosen.push_back(choices.orientations[k]);
    }
    return chosen;
}

}  // namespace

void require_phase_names(const MaterialChoices& choices) {
    std::vector<std::string> names;
    for (const PhaseFraction& phase : choices.phases) names.push_back(phase.name);
    for (const std::string& phase : names) require_free_name("the phase", phase, names);
}

void require_one_a_site(const MaterialChoices& choices, int n_sites) {
    const auto require = [n_sites](std::size_t n, const std::string& name,
                                   const std::string& remedy = "") {
        if (n == 0 || n == static_cast<std::size_t>(n_sites)) return;
        throw InvalidInput("there are " + std::to_string(n) + " " + name + " for " +
                           std::to_string(n_sites) + " sites; give one for each site" + remedy);
    };
    require(choices.site_phases.size(), "phases");
    if (choices.draws_from_list(n_sites)) return;
    require(choices.orientations.size(), "orientations",
            ", or a list to draw from, which is longer or has weights");
}

CellMaterials choose_materials(const MaterialChoices& choices, const CellTable& cells,
                               std::uint64_t seed) {
    require_one_a_site(choices, cells.n_cells());
    CellMaterials materials;
    std::vector<double> fractions;
    for (const PhaseFraction& phase : choices.phases) {
        materials.phase_names.push_back(phase.name);
        fractions.push_back(phase.fraction);
    }
    if (!choices.site_phases.empty()) {
        materials.site_phase = choices.site_phases;
    } else if (!fractions.empty()) {
        materials.site_phase = assign_phases(cells, fractions, seed);
    }
    materials.site_orientation = choose_orientations(choices, cells.n_cells(), seed);
    return materials;
}

std::vector<PhaseFigures> phase_figures(const MaterialChoices& choices,
                                        const CellMaterials& materials, const CellTable& cells) {
    if (choices.phases.empty()) return {};
    const std::vector<double> shares =
        phase_shares(cells, materials.site_phase, choices.phases.size());
    std::vector<PhaseFigures> figures;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const auto n_cells = std::count(materials.site_phase.begin(), materials.site_phase.end(),
                                        static_cast<int>(k));
        const double wanted = choices.site_phases.empty() ? choices.phases[k].fraction : shares[k];
        figures.push_back({choices.phases[k].name, wanted, shares[k], static_cast<int>(n_cells)});
    }
    return figures;
}

MaterialsOfCells materials_of_cells(const MaterialChoices& choices, const CellTable& cells,
                                    std::uint64_t seed) {
    MaterialsOfCells of_cells{.materials = choose_materials(choices, cells, seed)};
    of_cells.phases = phase_figures(choices, of_cells.materials, cells);
    return of_cells;
}

}  // namespace pcvt
