#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "mesher/base/site_id.hpp"
#include "mesher/space/space_lattice.hpp"

namespace pcvt {

/// A tetrahedron's number times 4 must remain an int.
inline constexpr int kMostSpaceSites = 1 << 26;

/// The sites of a 3-torus, in coordinates of the reduced basis.
///
/// Each coordinate is a multiple of 2^-50 in [0, 1), so that every image of a site and every
/// difference of nearby images is exact in a double. The exact predicates rely on this.
///
/// Example usage:
///
///     const SpaceLattice lattice = SpaceLattice::box(2, 1, 1);
///     const SpaceSites sites(lattice, uniform_points(lattice, 1000, 1));
///     const Vec3 p = sites.position(0);
class SpaceSites {
   public:
    /// Wraps points into the domain.
    /// @param lattice  any basis of the lattice.
    /// @param points   3 x n, n >= 1, length units; need not lie in the domain.
    /// @throws InvalidInput   no site, more than 2^26, or a coordinate that is not finite or lies
    ///         more than 2^30 periods away.
    /// @throws DuplicateSites naming the first two ids on one orbit, by the smaller and the larger.
    SpaceSites(const SpaceLattice& lattice, const Points3& points);
    /// Takes coordinates of the reduced basis and wraps them; does not check for duplicates.
    /// @param coordinates  3 x n, multiples of 2^-50.
    SpaceSites(const SpaceLattice& lattice, const SpaceReduction& reduction, Points3 coordinates);

    int n_sites() const { return static_cast<int>(coordinates_.cols()); }
    const SpaceLattice& lattice() const { return lattice_; }
    const SpaceReduction& reduction() const { return reduction_; }
    /// 3 x n, in [0, 1)^3, coordinates in the reduced basis.
    const Points3& coordinates() const { return coordinates_; }
    /// The image of the site with reduced coordinates in [0, 1)^3, length units.
    Vec3 position(SiteId site) const;
    /// The length scale h, the cube root of volume / n.
    double spacing() const;

    /// The first two ids on one orbit; {-1, -1} if all sites are distinct.
    std::pair<SiteId, SiteId> duplicates() const;

   private:
    SpaceLattice lattice_;
    SpaceReduction reduction_;
    Points3 coordinates_;
};

/// The chosen sites, in their order.
SpaceSites some_of(const SpaceSites& sites, std::span<const SiteId> chosen);

/// Draws n points uniformly from the fundamental domain; the same seed gives the same points on
/// every machine.
/// @returns 3 x n, length units.
Points3 uniform_points(const SpaceLattice& lattice, int n, std::uint64_t seed);

}  // namespace pcvt
