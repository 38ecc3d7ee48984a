#pragma once

#include <cstdint>
#include <optional>

#include "mesher/plane/cvt/coarse_levels.hpp"
#include "mesher/plane/symmetry/symmetric_sites.hpp"

namespace pcvt::plane {

/// Computes initial sites with a symmetry from coarse to fine, as coarse_start() does without one.
///
/// Example usage:
///   const PlaneGroup group(PlaneGroupName::kP4m, Lattice::rectangle(1, 1));
///   const OrbitPlan plan = distribute(group, special_positions(group), 2400);
///   CvtOptions options;
///   options.precondition_below = kPreconditionAfterCoarse;
///   const auto start = symmetric_coarse_start(group, plan, 1, {});
///   const CvtResult result = compute_cvt(*start, options);
///
/// Every level has the symmetry to the last bit. The orbits in general positions become four times
/// as many by the midpoints of Delaunay edges, one for each orbit of edges. An edge whose midpoint
/// lies at a centre of rotation or on a mirror adds the orbit of the point at a third of its
/// length, which is in a general position and as far from its images as from its neighbours; where
/// these are too many, some of them, evenly distributed, add nothing. An edge between cocircular
/// sites adds nothing either: which of the diagonals is an edge need not obey the symmetry. Sites
/// at centres and on mirrors are there on all levels; centres stay, and sites on mirrors are shaken
/// along them.
///
/// @param options  a density is folded (folded_density.hpp).
/// @returns the sites of the plan, numbered by columns; `nullopt` if the callback cancelled.
/// @throws as random_places does.
std::optional<SymmetricSites> symmetric_coarse_start(const PlaneGroup& group, const OrbitPlan& plan,
                                                     std::uint64_t seed,
                                                     const CoarseStartOptions& options);

}  // namespace pcvt::plane
