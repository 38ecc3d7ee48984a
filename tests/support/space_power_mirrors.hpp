#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesher/space/delaunay/torus_tetrahedra.hpp"

namespace pcvt::testing {

/// The periodic power diagram in space from a Euclidean one: CGAL's Regular_triangulation_3 of 5 x
/// 5 x 5 copies of the sites, with CGAL's exact predicates on rounded positions. Where those are
/// exact, as in cubes whose side is a power of two, its rule for ties is that of this library.
struct SpacePowerMirrors {
    /// One of each orbit, in canonical order: the least corner, by site and offset, comes first and
    /// has the offset (0, 0, 0); the others follow sorted.
    std::vector<space::Tetrahedron> tetrahedra;
    /// The sites without a cell.
    std::vector<SiteId> hidden;
};

/// @param weights  of each site, length^2.
SpacePowerMirrors space_power_mirrors(const space::Sites& sites, const Eigen::VectorXd& weights);

}  // namespace pcvt::testing
