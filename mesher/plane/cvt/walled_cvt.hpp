#pragma once

#include <functional>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/cvt/wall_rounds.hpp"

namespace pcvt::plane {

/// A CVT between walls, and the torus of which it is a part.
struct WalledCvt {
    /// The CVT of the domain and its mirror images. Energies, masses and bounds are those of the
    /// domain, in which the cell of a site on a wall counts as a half, in a corner as a quarter.
    CvtResult torus;
    /// Which sites of the torus belong to the domain.
    WalledDomain domain;
};

/// Moves sites to a CVT of a rectangle with walls: a minimum of the energy of the cells that the
/// walls clip, computed as a CVT of the torus with mirror symmetry.
///
/// Example usage:
///   const Lattice channel = Lattice::rectangle(4, 1);
///   const Points points = uniform_points(channel, 1000, 1);
///   const WalledCvt cvt = compute_walled_cvt(channel, Walls::kY, WallCells::kWhole, points, {});
///
/// Half cells come about in several runs (run_wall_rounds()). Counts are those of all these runs.
/// @param domain   upright.
/// @param points   2 x n, length units, between the walls.
/// @param options  a density is that of the domain. numbering and progress mean sites and energies
///                 of the domain.
/// @throws InvalidInput  a point lies beyond a wall; half cells do not come about.
/// @throws as compute_cvt does.
WalledCvt compute_walled_cvt(const Lattice& domain, Walls walls, WallCells cells, Points points,
                             const CvtOptions& options);

/// Optimises sites with mirror symmetry, which remain numbered as they are.
using SymmetricRun = std::function<CvtResult(const SymmetricSites&, const CvtOptions&)>;

/// The same by another method than compute_cvt(). The first n_sites sites that `run` receives are
/// the points, or from the second round for half cells on, the last sites, some moved onto walls.
/// @param domain   without n_on_walls.
/// @param points   2 x n_sites; they are numbered as given.
WalledCvt compute_walled_cvt(const WalledDomain& domain, WallCells cells, Points points,
                             const CvtOptions& options, const SymmetricRun& run);

}  // namespace pcvt::plane
