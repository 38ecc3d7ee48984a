#pragma once

#include <span>
#include <vector>

#include "io/colours/colouring.hpp"

namespace pcvt {

/// Quantities of the cells of a tile in space that colours may show.
struct CellQuantities {
    /// The number of faces of each cell.
    std::vector<int> n_faces;
    /// length^3; only for Colouring::kSize.
    std::vector<double> volumes = {};
    /// Of each cell a class that its neighbours do not have; only for Colouring::kCells.
    std::span<const int> classes = {};
    /// Null: none.
    const CellMaterials* materials = nullptr;
};

/// Returns the colours of cells in space: `class_of` has one entry a cell.
///
/// Example usage:
///     const TileColours colours = cell_colours(Colouring::kFaces, {.n_faces = counts});
///
/// @throws InternalError if cells in space do not have the quantity.
TileColours cell_colours(Colouring colouring, const CellQuantities& cells);

/// Returns the classes of orientations, one for each colour of pole_colour(), whose components are
/// rounded to multiples of 15, so that there are at most 867; `class_of` has one entry for each
/// orientation.
TileColours orientation_classes(std::span<const BungeAngles> angles);

/// Returns the classes of phases: from kCellColours phases on, colours repeat.
TileColours phase_classes(const CellMaterials& materials, std::span<const SiteId> cells);

}  // namespace pcvt
