#pragma once

#include <span>

#include "mesher/space/geometry/lattice.hpp"
#include "mesher/torus/sites.hpp"

namespace pcvt::space {

inline constexpr int kMostSites = Lattice::kMostSites;

using Sites = pcvt::Sites<Lattice>;
using pcvt::uniform_points;

/// The positions of the sites in the parallelepiped of the reduced basis with its corner at
/// `origin`, 3 x n, length units.
///
/// Example usage:
///   const Points points = wrapped_positions(sites, {-17.1, 3.25, -2});
Points wrapped_positions(const Sites& sites, const Vec3& origin);

/// The chosen sites, in their order.
Sites some_of(const Sites& sites, std::span<const SiteId> chosen);

}  // namespace pcvt::space

namespace pcvt {

extern template struct Reduction<space::Lattice>;
extern template class Sites<space::Lattice>;
extern template space::Points uniform_points(const space::Lattice& lattice, int n,
                                             std::uint64_t seed);

}  // namespace pcvt
