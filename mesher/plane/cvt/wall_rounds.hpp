#pragma once

#include <functional>

#include "mesher/optimize/objective.hpp"
#include "mesher/plane/delaunay/periodic_delaunay.hpp"
#include "mesher/plane/geometry/walled_domain.hpp"
#include "mesher/plane/symmetry/symmetric_sites.hpp"

namespace pcvt::plane {

/// The sites of the domain between its walls, 2 x n, length units; along the periodic direction
/// they are not wrapped.
Points points_between_walls(const PeriodicDelaunay& torus, const WalledDomain& domain);

/// The parts of the result of a run on the torus that run_wall_rounds() reads and changes.
struct WallRoundResult {
    PeriodicDelaunay& delaunay;
    RunStatistics& run;
};

/// Optimises sites with mirror symmetry.
/// @param before  the counts of the earlier rounds.
using WallRound =
    std::function<WallRoundResult(const SymmetricSites& sites, const RunStatistics& before)>;

/// The progress of a run on the torus as one of the domain, after earlier rounds.
/// @param progress, before  must outlive the result.
ProgressCallback progress_between_walls(const ProgressCallback& progress,
                                        const WalledDomain& domain, const RunStatistics& before);

/// Runs `round` on the sites and their mirror images. Half cells: the sites whose cells touch a
/// wall move onto it, and the run is repeated until only cells of sites on walls touch one.
///
/// Example usage:
///   std::optional<CvtResult> torus;
///   const WalledDomain domain = run_wall_rounds({Walls::kY, channel, n}, WallCells::kHalf, points,
///       [&](const SymmetricSites& sites, const RunStatistics&) -> WallRoundResult {
///           torus.emplace(compute_cvt(sites, {}));
///           return {torus->delaunay, torus->run};
///       });
///
/// In the last result, site k is point k, its images follow, the counts are those of all rounds,
/// and the energy is that of the domain.
/// @param domain  without n_on_walls.
/// @param points  2 x n_sites, length units, between the walls.
/// @throws InvalidInput  a point lies beyond a wall; half cells do not come about.
WalledDomain run_wall_rounds(WalledDomain domain, WallCells cells, Points points,
                             const WallRound& round);

}  // namespace pcvt::plane
