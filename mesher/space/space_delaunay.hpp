#pragma once

#include "mesher/space/torus_tetrahedra.hpp"

namespace pcvt {

/// Sites and their periodic Delaunay triangulation.
///
/// Example usage:
///
///     const SpaceDelaunay delaunay = space_delaunay(SpaceSites(lattice, points));
///     const Vec3 p = delaunay.sites.position(delaunay.tetrahedra.corner(0).site);
struct SpaceDelaunay {
    SpaceSites sites;
    TorusTetrahedra tetrahedra;
};

/// Triangulates sites by inserted_tetrahedra(), which is three times as fast as the mirrors; by
/// orbit_tetrahedra() where they are too unevenly spread for it; or by space_mirrors() where they
/// are few, or the box is long. All give the same tetrahedra.
TorusTetrahedra space_tetrahedra(const SpaceSites& sites);

/// The sites and space_tetrahedra().
SpaceDelaunay space_delaunay(const SpaceSites& sites);

/// Whether a facet is locally Delaunay, with the one rule for ties; exact. If all facets are and
/// all tetrahedra are positively oriented, the triangulation is the one that space_delaunay()
/// builds.
bool is_locally_delaunay(const TorusTetrahedra& tetrahedra, const Points3& coordinates,
                         const Gram3& gram, int facet);

/// Whether a tetrahedron is positively oriented; exact.
bool is_positive(const TorusTetrahedra& tetrahedra, const Points3& coordinates, int tetrahedron);

}  // namespace pcvt
