#pragma once

#include <optional>

#include "mesher/space/delaunay/torus_tetrahedra.hpp"

namespace pcvt::space {

/// The periodic Delaunay triangulation of sites that are spread unevenly: on a line, in a plane, on
/// a sphere, in a cluster. Some random sites are triangulated by mirror_diagram(), then the others
/// are inserted in random order with all of their images (growing_orbits.hpp), so that the expected
/// time is n log n plus the number of tetrahedra that random parts of the sites have.
///
/// Example usage:
///
///     std::optional<TorusTetrahedra> torus = orbit_tetrahedra(sites);
///     if (!torus) torus.emplace(sites.n_sites(), mirror_diagram(sites).tetrahedra);
///
/// @returns the tetrahedra in canonical order; nullopt for fewer sites than kFewestForOrbits, and
/// if
///          spheres extend too far for exact differences, as in long boxes.
/// @throws LimitExceeded if there are more than 2^29 tetrahedra.
std::optional<TorusTetrahedra> orbit_tetrahedra(const Sites& sites);

inline constexpr int kFewestForOrbits = 64;

/// The mean number of tetrahedra a site of sites that are spread evenly.
inline constexpr double kTetrahedraPerSite = 6.8;

/// The number of tetrahedra to expect, by those of some hundred of the sites and their growth:
/// about 6.8 n for most sites, n^2 / 4 for sites on two skew lines.
double expected_tetrahedra(const Sites& sites);

}  // namespace pcvt::space
