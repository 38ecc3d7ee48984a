#pragma once

#include <cstdint>
#include <utility>

#include "mesher/base/site_id.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::plane {

inline constexpr int kMostSites = 1 << 28;
/// In units of h = sqrt(area / n): sites closer than this are rejected, and the ends of a Voronoi
/// edge shorter than this are merged. Cocircular sites therefore share one vertex, and no edge of
/// zero length exists.
inline constexpr double kSameVertex = 1e-9;

/// The sites of a torus, in coordinates of the reduced basis.
///
/// Each coordinate is a multiple of 2^-51 in [0, 1), so that every image of a site and every
/// difference of nearby images is exact in a double. The exact predicates rely on this.
///
/// Example usage:
///
///     const Lattice lattice = Lattice::rectangle(2, 1);
///     const Sites sites(lattice, uniform_points(lattice, 1000, 1));
///     const Vec2 p = sites.position(0);
class Sites {
   public:
    /// Wraps points into the domain.
    /// @param lattice  any basis of the lattice.
    /// @param points   2 x n, n >= 1, length units; need not lie in the domain.
    /// @throws InvalidInput   no site, more than 2^28, or a coordinate that is not finite or lies
    ///         more than 2^30 periods away.
    /// @throws DuplicateSites naming the first two ids on one orbit, by the smaller and the larger.
    Sites(const Lattice& lattice, const Points& points);
    /// Takes coordinates of the reduced basis and wraps them; does not check for duplicates.
    /// @param coordinates  2 x n, multiples of 2^-51.
    Sites(const Lattice& lattice, const Reduction& reduction, Points coordinates);

    int n_sites() const { return static_cast<int>(coordinates_.cols()); }
    const Lattice& lattice() const { return lattice_; }
    const Reduction& reduction() const { return reduction_; }
    /// 2 x n, in [0, 1)^2, coordinates in the reduced basis.
    const Points& coordinates() const { return coordinates_; }
    /// The image of the site with reduced coordinates in [0, 1)^2, length units.
    Vec2 position(SiteId site) const;
    /// The length scale h = sqrt(area / n).
    double spacing() const;

    /// The first two ids on one orbit; {-1, -1} if all sites are distinct.
    std::pair<SiteId, SiteId> duplicates() const;

   private:
    Lattice lattice_;
    Reduction reduction_;
    Points coordinates_;
};

/// Draws n points uniformly from the fundamental domain; the same seed gives the same points on
/// every machine.
/// @returns 2 x n, length units.
Points uniform_points(const Lattice& lattice, int n, std::uint64_t seed);

}  // namespace pcvt::plane
