#pragma once

#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt::space {

/// Polyhedra, and the sites and the rounding that their file states.
struct StatedPolyhedra {
    const PolyhedralMesh& mesh;
    /// 3 x n, the image of each site that its cell belongs to, length units; none where the file
    /// states no sites.
    const Points& sites;
    /// length^2, one a site; empty for Voronoi cells.
    const Eigen::VectorXd& weights;
    /// The rounding of a position, length units.
    double rounding;
};

/// The cell whose volume differs most from its target, in units of the tolerance.
struct VolumeComparison {
    int cell;
    /// length^3
    double volume;
    /// |volume - target| over the mean volume.
    double error;
    /// Over the mean volume: the least one, or more where rounding changes the volume by more.
    double tolerance;
};

/// Compares the volumes of polyhedra with target volumes. The tolerance of a cell is `least` times
/// the mean volume or its own, whichever is larger, or as much as its volume changes where
///   - its faces move by the rounding of positions, and by the largest distance of a corner from
///   the
///     plane between the two sites, which is not zero where near corners were merged;
///   - the rounding of sites and weights moves these planes: by the rounding of power distances
///   over
///     2 d, with d the distance of the two sites.
///
/// Example usage:
///
///     const VolumeComparison found = compare_volumes(
///         {mesh, sites, weights, proof.tolerance}, wanted, 10 * volume_tolerance(mesh.n_cells));
///     if (found.error > found.tolerance) refuse(found.cell);
///
/// Laws, tested by number:
///   (1) The volumes are those of brute force.
///   (2) Two cells whose targets are exchanged are refuted, unless these differ by less than the
///       tolerance.
///
/// @pre prove_polyhedra() and, where there are sites, prove_cell_sites() have proved the mesh.
/// @param wanted  one a cell, positive, length^3, with the sum of the volume of the domain.
VolumeComparison compare_volumes(const StatedPolyhedra& polyhedra, const Eigen::VectorXd& wanted,
                                 double least);

}  // namespace pcvt::space
