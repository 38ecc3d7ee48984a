#pragma once

#include "mesher/plane/geometry/lattice.hpp"
#include "mesher/torus/sites.hpp"

namespace pcvt::plane {

inline constexpr int kMostSites = Lattice::kMostSites;
/// In units of h = sqrt(area / n): sites closer than this are rejected, and the ends of a Voronoi
/// edge shorter than this are merged. Cocircular sites therefore share one vertex, and no edge of
/// zero length exists.
inline constexpr double kSameVertex = 1e-9;

using Sites = pcvt::Sites<Lattice>;
using pcvt::uniform_points;

}  // namespace pcvt::plane

namespace pcvt {

extern template struct Reduction<plane::Lattice>;
extern template class Sites<plane::Lattice>;
extern template plane::Points uniform_points(const plane::Lattice& lattice, int n,
                                             std::uint64_t seed);

}  // namespace pcvt
