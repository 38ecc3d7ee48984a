#pragma once

#include <cstdint>
#include <memory>

#include "mesher/space/geometry/lattice.hpp"

namespace pcvt::bench {

/// A peer's triangulation of points in the unit cube.
struct SpaceTriangulation {
    std::int64_t n_vertices = 0;
    /// Without the infinite ones; periodic ones count once per orbit.
    std::int64_t n_tetrahedra = 0;
    /// The constructed object, alive until the caller drops it, so that its destruction need not be
    /// timed.
    std::shared_ptr<const void> structure;
};

/// @param points  3 x n in [0, 1)^3.
using SpacePeer = SpaceTriangulation(const space::Points& points);

/// CGAL's Delaunay_triangulation_3 of the n points by one spatially sorted insertion, not periodic.
/// The unit of all ratios in space.
SpaceTriangulation cgal_plain_in_space(const space::Points& points);

/// CGAL's Periodic_3_Delaunay_triangulation_3 by its insertion for large sets, with dummy points.
SpaceTriangulation cgal_periodic_in_space(const space::Points& points);

}  // namespace pcvt::bench
