#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesher/cells/cell_table.hpp"

namespace pcvt {

/// Gives each cell a phase, so that the phases have prescribed fractions of the area and lie evenly
/// over the torus. Laws, tested by number:
///
///   (1) The area of each phase differs from its target by at most (1 - 1 / K) of the smallest
///       cell, K the number of phases: half of it for two phases, and no less is possible for equal
///       cells in general. Where cells are so few, or the smallest one so small, that exchanges of
///       cells do not reach this, the best assignment of some tens of attempts is returned.
///   (2) Of all sides between cells, at most the share sum_k (D_k / D)^2 lies between cells of
///       equal phase, with D_k of all D sides on cells of the phase k: neighbours have equal phases
///       at most as often as at random.
///   (3) No phase prefers cells with few sides, or small ones.
///   (4) The same cells, fractions and seed give the same phases on every machine.
///
/// A random assignment is made even by exchanges of two cells with equally many sides that lower
///
///   Q = sum over cells s and phases k of (c_sk - f_k m_s)^2,
///
/// where c_sk is the number of cells with the phase k among s and its neighbours, m_s the number of
/// these cells and f_k the fraction. Then cells move and are exchanged until law (1) holds.
///
/// Example usage:
///
///     const CellTable cells = cell_table(cell_mesh(delaunay));
///     const std::vector<int> phase = assign_phases(cells, std::array{0.3, 0.7}, seed);
///
/// @param fractions  positive, with the sum 1.
/// @returns the index of the phase of each cell. Cost: of order n log n.
std::vector<int> assign_phases(const CellTable& cells, std::span<const double> fractions,
                               std::uint64_t seed);

/// The share of the total area, or volume, that each of `n_phases` phases has.
std::vector<double> phase_shares(const CellTable& cells, std::span<const int> site_phase,
                                 std::size_t n_phases);

}  // namespace pcvt
