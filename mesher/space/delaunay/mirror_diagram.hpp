#pragma once

#include "mesher/space/delaunay/torus_tetrahedra.hpp"

namespace pcvt::space {

/// The periodic Delaunay triangulation from a Euclidean one (the paper's mirrors, in space).
///
/// Example usage:
///
///     const MirrorDiagram mirrors = mirror_diagram(sites);
///     const TorusTetrahedra torus(sites.n_sites(), mirrors.tetrahedra);
struct MirrorDiagram {
    /// One of each orbit: the one whose corner with the smallest site id (then the smallest offset)
    /// has the offset (0, 0, 0), sorted by that site.
    std::vector<Tetrahedron> tetrahedra;
    /// Images inserted in addition to the n sites.
    int n_mirrors = 0;
};

/// Triangulates the sites together with their images in a band round the domain, then inserts
/// images where they are needed, until the star of each site in the domain is right.
///
/// An image is needed if it lies inside or on the circumsphere of a tetrahedron at a site of the
/// domain [0, 1)^3. Since every image inside of the band is present, only spheres that reach out of
/// it are examined. Where a site of the domain lies on the convex hull, its own 26 neighbours are
/// inserted. Exact ties are broken by a rule that is the same for all images
/// (predicates.hpp).
/// @throws InternalError if the tetrahedra do not fill the torus.
MirrorDiagram mirror_diagram(const Sites& sites);

/// The slow reference method: triangulates all 5 x 5 x 5 copies of the sites.
MirrorDiagram full_copies_diagram(const Sites& sites);

/// The Euclidean Delaunay triangulation of only the n sites, by the same predicates: the reference
/// for the cost of the mirrors.
/// @returns the number of its tetrahedra.
std::size_t euclidean_tetrahedra(const Sites& sites);

}  // namespace pcvt::space
