#pragma once

#include <cstdint>

#include "mesher/plane/cvt/coarse_levels.hpp"

namespace pcvt::plane {

/// Computes initial sites for an optimisation, from coarse to fine.
///
/// Example usage:
///   const Lattice unit = Lattice::rectangle(1, 1);
///   CvtOptions options;
///   options.precondition_below = kPreconditionAfterCoarse;
///   const CvtResult result = compute_cvt(unit, coarse_start(unit, 1000, 1, {}), options);
///
/// The coarsest problem has n / 16 random sites. Each level optimises its sites, adds the midpoints
/// of the Delaunay edges, which quadruples the number of sites, and shakes all sites. Long waves
/// converge on the coarse levels, where there are few sites. The optimisation that follows needs
/// fewer iterations than one from random sites and ends in a different, lower minimum with fewer
/// non-hexagonal cells. With a density this holds only where the coarsest cells resolve it
/// (is_resolved_by_coarse_cells()); if the density jumps, or if an image has finer detail, the
/// minimum is higher (by 3 % for a checkerboard of contrast 1:100 and 10,000 sites).
///
/// Between walls, the levels are walled CVTs of whole cells. The edge between a site and its mirror
/// image adds a site half way to the wall in place of its midpoint, which lies on the wall; so the
/// number of sites quadruples there too.
///
/// @param walls  the sides of the lattice, upright then, that are walls; the sites lie between
/// them.
/// @returns 2 x n, length units; no columns if the callback cancelled.
Points coarse_start(const Lattice& lattice, int n, std::uint64_t seed,
                    const CoarseStartOptions& options, Walls walls = Walls::kNone);

/// Whether the coarsest cells of a coarse start of n sites resolve a density: ln rho changes by
/// less than 3 from one of them to the next.
///
/// Energies of coarse starts, mean of four seeds, against those of random sites, and their times:
/// at 4,000 sites, a peak of 1:200 with a change of 2.3 0.27 % lower in 0.9 of the time, one of 4.4
/// 0.15 % lower in 0.6, and waves with 6.3 0.04 % lower in 3 times; with jumps 0.4 to 9 % higher.
/// At 20,000 sites these peaks are 0.2 to 0.4 % lower in 0.55 to 0.65 of the time.
bool is_resolved_by_coarse_cells(const Lattice& lattice, const Density& density, int n);

}  // namespace pcvt::plane
