#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesher/plane/delaunay/site_moves.hpp"
#include "mesher/plane/density/density.hpp"
#include "mesher/plane/geometry/sites.hpp"
#include "mesher/plane/symmetry/special_positions.hpp"

namespace pcvt::plane {

/// The images of one site under a plane group.
struct SiteOrbit {
    /// The site whose image each other site of the orbit is.
    SiteId representative = 0;
    int n_sites = 0;
    /// How many directions the representative may move in: 2, 1 along a mirror, 0 at a centre.
    int freedom = 2;
    /// The direction in which the representative may move along its mirror, reduced basis.
    std::array<int, 2> along{0, 0};
};

/// The sites of one period that a plane group maps to each other.
///
/// Example usage:
///
///     const PlaneGroup group(PlaneGroupName::kP4m, Lattice::rectangle(1, 1));
///     const SymmetricSites start = random_sites(group, plan, 1);
///     const CvtResult cvt = compute_cvt(start, {});
///
/// Law (1): the sites of an orbit are the images of its representative to the last bit; centres
/// with coordinates in thirds of a period are rounded to multiples of 2^-51.
struct SymmetricSites {
    PlaneGroup group;
    Sites sites;
    /// The orbit of each site.
    std::vector<int> orbit;
    std::vector<SiteOrbit> orbits;
    /// One tie a site; MovingDelaunay::tie_moves uses it to keep the orbits exact.
    std::vector<MoveTie> ties;
};

/// Places for the representatives of orbits.
struct OrbitPlaces {
    /// Whether each of SpecialPositions::centres is occupied.
    std::vector<bool> at_centres;
    /// For each of SpecialPositions::mirrors: places in parts of its length.
    std::vector<std::vector<double>> on_mirrors;
    /// In general positions, 2 x n, length units.
    Points general;
};

/// Random places for a plan of orbits, distributed evenly over the domain, or over the mirror. The
/// same seed gives the same places on every machine.
/// @param density  `nullopt`: even; else in general positions drawn from its square root.
/// @throws InvalidInput if the plan has no site, more than kMostSites, or does not fit the group.
OrbitPlaces random_places(const PlaneGroup& group, const OrbitPlan& plan, std::uint64_t seed,
                          const std::optional<Density>& density = std::nullopt);

/// The orbits of the places: centres, then sites on mirrors, then general positions.
/// @throws DuplicateSites if two sites coincide.
SymmetricSites sites_at(const PlaneGroup& group, const OrbitPlaces& places);

/// sites_at() random_places().
SymmetricSites random_sites(const PlaneGroup& group, const OrbitPlan& plan, std::uint64_t seed,
                            const std::optional<Density>& density = std::nullopt);

/// The orbits of the given points, one for each; ids count the images of the first point, then
/// those of the second. A point that is not farther from a centre or a mirror than kSameVertex h is
/// moved there.
/// @param representatives  2 x n, length units.
/// @throws DuplicateSites if two points coincide or are images of each other.
SymmetricSites orbits_of(const PlaneGroup& group, const Points& representatives);

/// The same sites in another order.
/// @param order  a permutation of the ids: site k of the result is site order[k].
SymmetricSites renumbered(const SymmetricSites& sites, const std::vector<SiteId>& order);

/// The same sites numbered by columns (Numbering::kByColumns).
SymmetricSites numbered_by_columns(const SymmetricSites& sites);

}  // namespace pcvt::plane
