#pragma once

#include "mesher/space/delaunay/torus_tetrahedra.hpp"

namespace pcvt::space {

/// Sites and their periodic Delaunay triangulation; with weights their regular triangulation, the
/// dual of the power diagram.
///
/// Example usage:
///
///     const PeriodicDelaunay delaunay = periodic_delaunay(Sites(lattice, points));
///     const Vec3 p = delaunay.sites.position(delaunay.tetrahedra.corner(0).site);
struct PeriodicDelaunay {
    Sites sites;
    TorusTetrahedra tetrahedra;
    /// The weight of each site, length^2; empty: all are equal.
    Eigen::VectorXd weights = {};
};

/// Triangulates sites by inserted_tetrahedra(), which is three times as fast as the mirrors; by
/// orbit_tetrahedra() where they are too unevenly spread for it; or by mirror_diagram() where they
/// are few, or the box is long. All give the same tetrahedra.
TorusTetrahedra torus_tetrahedra(const Sites& sites);

/// The sites and torus_tetrahedra().
PeriodicDelaunay periodic_delaunay(const Sites& sites);

/// Whether a facet is locally Delaunay, with the one rule for ties; exact. If all facets are and
/// all tetrahedra are positively oriented, the triangulation is the one that periodic_delaunay()
/// builds.
bool is_locally_delaunay(const TorusTetrahedra& tetrahedra, const Points& coordinates,
                         const Gram& gram, int facet);

/// Whether a tetrahedron is positively oriented; exact.
bool is_positive(const TorusTetrahedra& tetrahedra, const Points& coordinates, int tetrahedron);

}  // namespace pcvt::space
