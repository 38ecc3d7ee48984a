#pragma once

#include <optional>

#include "mesher/space/grains/cell_refinement.hpp"

namespace pcvt::space {

/// The sine of 30 degrees: angles beyond need no improvement.
inline constexpr double kTargetSine = 0.5;

/// Raises the smallest sines of a cell: moves vertices, flips tetrahedra, and adds and removes
/// vertices.
/// @param n_relaxations  rounds of VertexMoves::relax() first.
void climb(CellTetrahedra& cell, int n_relaxations);

/// Fills a cell with tetrahedra. Where an angle remains below 20 degrees, several attempts are made
/// with other densities, and the best one stays.
///
/// Example usage:
///     const std::optional<CellTetrahedra> cell = fill_cell(hull, size);
///
/// Law, tested by number:
///   (1) The laws of CellTetrahedra hold.
///
/// @param size  the target length of edges, length units.
/// @returns nothing if no point sees the whole hull from inside.
std::optional<CellTetrahedra> fill_cell(const CellHull& hull, double size);

}  // namespace pcvt::space
