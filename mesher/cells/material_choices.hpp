#pragma once

#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "mesher/cells/cell_materials.hpp"
#include "mesher/cells/cell_table.hpp"
#include "mesher/cells/phase_fractions.hpp"

namespace pcvt {

/// The materials that a user chooses.
struct MaterialChoices {
    /// As checked_phases() returns them; empty: no phases.
    std::vector<PhaseFraction> phases = {};
    /// The index of each site's phase in `phases`, whose fractions then do not count; empty: the
    /// phases are spread evenly.
    std::vector<int> site_phases = {};
    bool draws_orientations = false;
    /// The orientations of sites 0 ... n - 1, or a list from which those of the sites are drawn:
    /// see draws_from_list(). Empty: no orientations, or random ones.
    std::vector<BungeAngles> orientations = {};
    /// The weights of a list, one an orientation, not negative and not all zero; empty: all alike.
    std::vector<double> orientation_weights = {};
    /// The file of the list, with the column of its weights, for the summary.
    std::string orientation_source = {};

    /// Whether the orientations are a list: they have weights, or are more than the sites.
    bool draws_from_list(int n_sites) const {
        return !orientation_weights.empty() || std::ssize(orientations) > n_sites;
    }
    bool has_orientations() const { return draws_orientations || !orientations.empty(); }
    bool empty() const { return phases.empty() && !has_orientations(); }
};

/// The target share and the reached share of a phase.
struct PhaseFigures {
    std::string name;
    /// Shares of the total area, or volume. Of given phases the target is the share they have.
    double wanted;
    double reached;
    int n_cells;
};

/// Gives each cell its phase and its orientation.
///
/// Example usage:
///
///     const CellMaterials materials =
///         choose_materials({.phases = parse_phases("a:0.3,b:0.7")}, cells, seed);
///
/// @throws InvalidInput as require_one_a_site() does.
CellMaterials choose_materials(const MaterialChoices& choices, const CellTable& cells,
                               std::uint64_t seed);

/// The materials of the cells of a run, and one entry a phase.
struct MaterialsOfCells {
    CellMaterials materials = {};
    std::vector<PhaseFigures> phases = {};
};

/// choose_materials() and phase_figures() in one.
MaterialsOfCells materials_of_cells(const MaterialChoices& choices, const CellTable& cells,
                                    std::uint64_t seed);

/// Requires that no phase has the name of a set, group or patch which files may contain beside
/// those of the phases.
/// @throws InvalidInput naming the first such phase.
void require_phase_names(const MaterialChoices& choices);

/// @throws InvalidInput if there are given phases, but not n_sites, or orientations that are
/// neither
///         n_sites nor a list.
void require_one_a_site(const MaterialChoices& choices, int n_sites);

/// One entry a phase.
std::vector<PhaseFigures> phase_figures(const MaterialChoices& choices,
                                        const CellMaterials& materials, const CellTable& cells);

}  // namespace pcvt
