#pragma once

#include "io/forms/space_tile.hpp"
#include "mesher/space/tessellation/tessellation.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {

/// The corner of the domain of a job's tile: that of the job, or for a box the one that was found
/// for the cells.
space::Vec3 tile_origin(const Job& job, const space::Tessellation& cells);

/// Returns the cells of a tile: their pieces for a box, else the cells themselves.
///
/// Example usage:
///     const space::CellComplex complex = outlined_cells(job, cells, cells.complex());
///
/// @param snapped  as cells_in_box() takes it.
/// @throws space::UncutCells
space::CellComplex outlined_cells(const Job& job, const space::Tessellation& cells,
                                  space::CellComplex complex, double snapped = 0);

/// Completes a tile of pieces whose weights and materials are those of the cells: gives these to
/// the pieces, and puts the points of the sides exactly there. If the box cuts no cell, the tile
/// has whole cells afterwards.
void make_box(const space::Vec3& origin, SpaceTile& tile);

/// @throws NotATile  a side of the box is not flat.
void require_box(const space::PolyhedralMesh& mesh, double tolerance);

}  // namespace pcvt
