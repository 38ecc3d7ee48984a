#pragma once

#include "mesher/finite_volume/mpas_grid.hpp"
#include "mesher/proof/validate.hpp"

namespace pcvt {

/// What prove_mpas_grid measured; relative amounts.
struct MpasGridProof {
    /// Largest deviation of lengths, angles and edge points, in units of h = sqrt(area / n_cells).
    double geometry;
    /// Of the areas, in units of the mean area of a cell.
    double areas;
    /// Of the TRiSK identity for random velocities between -1 and 1, in units of h.
    double trisk;
};

/// Proves the laws of MpasGrid from the tables alone; sizes of tables must be right.
///
/// Tolerances: 1e-12 for areas and for the identity; for the geometry, 1e-10 and the rounding of
/// the largest coordinate.
/// @throws NotATile naming the law, the cell, edge or vertex (from 0), and the amount.
MpasGridProof prove_mpas_grid(const MpasGrid& grid);

}  // namespace pcvt
