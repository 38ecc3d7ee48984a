#pragma once

#include <cstdint>

#include "mesher/plane/cvt/walled_cvt.hpp"
#include "mesher/plane/interfaces/interface_sites.hpp"

namespace pcvt::plane {

/// A CVT with the interfaces of inclusions as edges of its cells.
struct InterfaceCvt {
    /// The seeds first, then the free sites. Energies are those of all cells; residuals are those
    /// of the free sites.
    CvtResult cvt;
    /// Between walls: `cvt` is that of the domain and its mirror images, as in WalledCvt.
    std::optional<WalledDomain> walled = {};
    InterfaceSites interfaces;
    /// For each site of the domain, its inclusion, or -1, and the tag of that inclusion, or 0.
    std::vector<int> inclusion;
    std::vector<int> tag;
    /// Free sites that were stopped at a circle, where they would have moved on.
    std::vector<SiteId> held;
};

/// Computes a CVT of n sites in which every chord of the inclusions is an edge between two cells.
/// Pairs of seeds beside the chords are fixed; the other sites minimise the energy outside of the
/// circles round the nodes (interface_sites.hpp). A site that runs into a circle again and again
/// stays there.
///
/// Example usage:
///
///     const InclusionSet set(lattice, {{Circle{{0.5, 0.5}, 0.2}, 1, 1}});
///     const InterfaceCvt result = compute_interface_cvt(set, 1000, 1, {});
///     const PeriodicMesh cells = cell_mesh(result.cvt.delaunay);
///
/// Laws, tested by number:
///   (1) The seeds are those of `interfaces`, to the last bit.
///   (2) No site lies inside of a circle.
///   (3) interface_violation() finds nothing wrong (mesh/interface_proof.hpp).
///
/// @param n        sites in all, of the domain.
/// @param options  a density is that of the domain; without fixed sites and guard; sites are
/// numbered as said above.
/// @param cells    of a set between walls.
/// @throws InvalidInput naming a number that suffices if n is too small; an outline is too near to
///         a wall for half cells, or these do not come about.
/// @throws as place_interface_sites and compute_cvt do.
InterfaceCvt compute_interface_cvt(const InclusionSet& set, int n, std::uint64_t seed,
                                   const CvtOptions& options, WallCells cells = WallCells::kWhole);

/// The inclusion in whose polygon of chords each site lies; -1: none. Mirror images lie in none.
std::vector<int> inclusions_of_sites(const Sites& sites, const InterfaceSites& interfaces);

}  // namespace pcvt::plane
