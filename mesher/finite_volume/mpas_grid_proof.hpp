#pragma once

#include "mesher/finite_volume/mpas_grid.hpp"
#include "mesher/plane/proof/validate.hpp"

namespace pcvt {

/// The deviations that prove_mpas_grid measured, all relative.
struct MpasGridProof {
    /// The largest deviation of lengths, angles and edge points, in units of h = sqrt(area /
    /// n_cells).
    double geometry;
    /// The largest deviation of the areas, in units of the mean area of a cell.
    double areas;
    /// The largest deviation from the TRiSK identity for random velocities between -1 and 1, in
    /// units of h.
    double trisk;
};

/// Proves the laws of MpasGrid from nothing but the tables.
///
/// Example usage:
///   std::cout << "TRiSK deviation " << prove_mpas_grid(grid).trisk << "\n";
///
/// Tolerances: 1e-12 for areas and for the identity; for the geometry, 1e-10 plus the rounding
/// error of the largest coordinate.
/// @pre The tables have the sizes that MpasGrid states.
/// @throws NotATile naming the law, the cell, edge or vertex (from 0), and the amount.
MpasGridProof prove_mpas_grid(const MpasGrid& grid);

}  // namespace pcvt
