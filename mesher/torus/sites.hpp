#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "mesher/base/site_id.hpp"

namespace pcvt {

/// A reduced basis of a lattice, and its coefficients in the original basis: Gauss-reduced in the
/// plane, Minkowski-reduced in space.
///
/// Laws, tested by number, for D dimensions:
///   (1) Period r of `reduced` is the sum over k of m[D r + k] times period k, and det m is +1 or
///       -1.
///   (2) Each of the reduced periods is a shortest vector of the lattice that extends the periods
///       before it to a basis, up to rounding; they are right-handed.
///   (3) lattice.translation(to_original(o)) = reduced.translation(o) up to rounding.
template <class Lattice>
struct Reduction {
    Lattice reduced;
    std::array<int, Lattice::kDimension * Lattice::kDimension> m;

    /// Converts an offset in the reduced basis to the original basis.
    typename Lattice::Offset to_original(typename Lattice::Offset reduced_offset) const;
};

/// The sites of a torus, in coordinates of the reduced basis.
///
/// Each coordinate is a multiple of Lattice::kGrain in [0, 1), so that every image of a site and
/// every difference of nearby images is exact in a double. The exact predicates rely on this.
///
/// Example usage:
///
///     const Lattice lattice = Lattice::rectangle(2, 1);
///     const Sites sites(lattice, uniform_points(lattice, 1000, 1));
///     const Vec2 p = sites.position(0);
template <class Lattice>
class Sites {
   public:
    using Point = typename Lattice::Point;
    /// One point a column.
    using Points = typename Lattice::Points;

    /// Wraps points into the domain.
    /// @param lattice  any basis of the lattice.
    /// @param points   D x n, n >= 1, length units; need not lie in the domain.
    /// @throws InvalidInput   no site, more than Lattice::kMostSites, or a coordinate that is not
    ///         finite or lies more than 2^30 periods away.
    /// @throws DuplicateSites naming the first two ids on one orbit, by the smaller and the larger.
    Sites(const Lattice& lattice, const Points& points);
    /// Takes coordinates of the reduced basis and wraps them; does not check for duplicates.
    /// @param coordinates  D x n, multiples of Lattice::kGrain.
    Sites(const Lattice& lattice, const Reduction<Lattice>& reduction, Points coordinates);

    int n_sites() const { return static_cast<int>(coordinates_.cols()); }
    const Lattice& lattice() const { return lattice_; }
    const Reduction<Lattice>& reduction() const { return reduction_; }
    /// D x n, in [0, 1)^D, coordinates in the reduced basis.
    const Points& coordinates() const { return coordinates_; }
    /// The image of the site with reduced coordinates in [0, 1)^D, length units.
    Point position(SiteId site) const;
    /// Those of all sites, one a column.
    Points positions() const;
    /// The length scale h, the D-th root of the measure of the domain over n.
    double spacing() const { return lattice_.spacing(n_sites()); }

    /// The first two ids on one orbit; {-1, -1} if all sites are distinct.
    std::pair<SiteId, SiteId> duplicates() const { return first_equal_sites(coordinates_); }

   private:
    Lattice lattice_;
    Reduction<Lattice> reduction_;
    Points coordinates_;
};

/// Draws n points uniformly from the fundamental domain; the same seed gives the same points on
/// every machine.
/// @returns D x n, length units.
template <class Lattice>
typename Lattice::Points uniform_points(const Lattice& lattice, int n, std::uint64_t seed);

}  // namespace pcvt
