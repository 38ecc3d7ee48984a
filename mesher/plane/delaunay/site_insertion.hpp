#pragma once

#include <vector>

#include "mesher/plane/delaunay/torus_triangulation.hpp"

namespace pcvt::plane {

/// The periodic Delaunay triangulation of sites that are inserted in random order, each with all of
/// its images, by Lawson's flips. The expected time is n log n for any sites, also on a line or on
/// a circle, where strips and mirrors take the square of n; for sites that are spread evenly it is
/// some times that of strips. Exact ties are broken as in mirror_diagram().
///
/// Example usage:
///
///     const TorusTriangulation torus(sites.n_sites(), inserted_triangles(sites));
///
/// Law, tested by number:
///   (1) The triangles are those of mirror_diagram(), in the same order.
/// @param n_first  the number of sites that mirrors triangulate first, at least 1.
std::vector<Triangle> inserted_triangles(const Sites& sites, int n_first = 16);

}  // namespace pcvt::plane
