#pragma once

#include <cstdint>

#include "mesher/plane/interfaces/interface_sites.hpp"

namespace pcvt::plane {

struct FreeSitesOptions {
    int n = 0;
    std::uint64_t seed = 0;
    /// The target distance of neighbours at a point, length units, up to a factor.
    std::function<double(const Vec2&)> spacing;
    /// Draws points, 2 x n, length units, from the density of sites.
    std::function<Points(int n, std::uint64_t seed)> draw;
};

/// Random sites outside of all circles that keep a distance from each other and from the seeds:
/// darts at a distance that shrinks until all sites are placed. Every region between interfaces,
/// which sites do not leave later, gets its share of them. The same seed gives the same sites on
/// every machine. Between walls they keep the distance from the mirror images as well.
///
/// @param options  between walls, `draw` draws points between them.
/// @returns 2 x n, reduced basis, multiples of 2^-51 in [0, 1).
Points free_sites(const InclusionSet& set, const InterfaceSites& interfaces,
                  const FreeSitesOptions& options);

}  // namespace pcvt::plane
