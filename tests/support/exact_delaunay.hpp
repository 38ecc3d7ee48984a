#pragma once

#include <string>

#include "mesher/space/delaunay/torus_tetrahedra.hpp"

namespace pcvt::testing {

/// Proves that tetrahedra are the periodic Delaunay triangulation of sites in space, or names the
/// first fault. All decisions are made with integers of 512 bits, by other formulas than those of
/// mesher/space/delaunay/predicates.hpp:
///
///   (1) Every tetrahedron is positive, every facet has one tetrahedron on each side, and the
///       volumes sum to exactly one domain. So the tetrahedra fill the torus once.
///   (2) No image of a site lies inside of a circumsphere, nor on it against the rule for ties: for
///       each tetrahedron all images in a box round its sphere are examined, without a limit on
///       their number.
///
/// Example usage:
///
///     EXPECT_EQ(delaunay_fault(delaunay.tetrahedra, delaunay.sites.coordinates(), gram), "");
///
/// @param coordinates  3 x n, multiples of 2^-50.
/// @returns "" for a proof.
std::string delaunay_fault(const space::TorusTetrahedra& tetrahedra,
                           const space::Points& coordinates, const space::Gram& gram);

}  // namespace pcvt::testing
