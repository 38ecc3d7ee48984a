#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "mesher/base/site_id.hpp"
#include "mesher/space/geometry/lattice.hpp"

namespace pcvt::space {

/// A tetrahedron's number times 4 must remain an int.
inline constexpr int kMostSites = 1 << 26;

/// The sites of a 3-torus, in coordinates of the reduced basis.
///
/// Each coordinate is a multiple of 2^-50 in [0, 1), so that every image of a site and every
/// difference of nearby images is exact in a double. The exact predicates rely on this.
///
/// Example usage:
///
///     const Lattice lattice = Lattice::box(2, 1, 1);
///     const Sites sites(lattice, uniform_points(lattice, 1000, 1));
///     const Vec3 p = sites.position(0);
class Sites {
   public:
    /// Wraps points into the domain.
    /// @param lattice  any basis of the lattice.
    /// @param points   3 x n, n >= 1, length units; need not lie in the domain.
    /// @throws InvalidInput   no site, more than 2^26, or a coordinate that is not finite or lies
    ///         more than 2^30 periods away.
    /// @throws DuplicateSites naming the first two ids on one orbit, by the smaller and the larger.
    Sites(const Lattice& lattice, const Points& points);
    /// Takes coordinates of the reduced basis and wraps them; does not check for duplicates.
    /// @param coordinates  3 x n, multiples of 2^-50.
    Sites(const Lattice& lattice, const Reduction& reduction, Points coordinates);

    int n_sites() const { return static_cast<int>(coordinates_.cols()); }
    const Lattice& lattice() const { return lattice_; }
    const Reduction& reduction() const { return reduction_; }
    /// 3 x n, in [0, 1)^3, coordinates in the reduced basis.
    const Points& coordinates() const { return coordinates_; }
    /// The image of the site with reduced coordinates in [0, 1)^3, length units.
    Vec3 position(SiteId site) const;
    /// The length scale h, the cube root of volume / n.
    double spacing() const;

    /// The first two ids on one orbit; {-1, -1} if all sites are distinct.
    std::pair<SiteId, SiteId> duplicates() const;

   private:
    Lattice lattice_;
    Reduction reduction_;
    Points coordinates_;
};

/// The chosen sites, in their order.
Sites some_of(const Sites& sites, std::span<const SiteId> chosen);

/// Draws n points uniformly from the fundamental domain; the same seed gives the same points on
/// every machine.
/// @returns 3 x n, length units.
Points uniform_points(const Lattice& lattice, int n, std::uint64_t seed);

}  // namespace pcvt::space
