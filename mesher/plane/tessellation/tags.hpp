#pragma once

#include <cstdint>
#include <vector>

#include "mesher/cells/material_choices.hpp"
#include "mesher/plane/tessellation/tessellation.hpp"

namespace pcvt::plane {

/// The tags of cells round inclusions as their phases, in the order matrix, 1, 2, ..., without the
/// tags of holes; one entry a site outside of holes.
///
/// Example usage:
///     const CellMaterials materials = tag_materials(cells);
///     const std::string& phase = materials.phase_names[materials.site_phase[0]];
CellMaterials tag_materials(const Tessellation& tessellation);

/// One entry a tag, also of holes; the targets are the areas of the shapes.
std::vector<PhaseFigures> tag_figures(const Tessellation& tessellation);

/// The materials of the sites outside of holes, and one entry a phase or tag. Round inclusions, the
/// tags are the phases; other cells have what the choices say, drawn by `seed`. Makes no table of
/// cells that have no materials.
/// @throws InvalidInput as choose_materials() does.
MaterialsOfCells materials_of_sites(const Tessellation& tessellation,
                                    const MaterialChoices& choices, std::uint64_t seed);

}  // namespace pcvt::plane
