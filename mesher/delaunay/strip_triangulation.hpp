#pragma once

#include <optional>

#include "mesher/delaunay/spatial_sort.hpp"
#include "mesher/delaunay/torus_triangulation.hpp"

namespace pcvt {

/// Some triangulation of the torus, from any n >= 1 on: the start for Lawson's flips.
///
/// The sites of a column, joined in their order, form a chain that closes round the torus and is
/// monotone in the second coordinate. The annular strip between two neighbouring chains is
/// triangulated as a monotone polygon (M. Garey et al. 1978), cut open along one edge between the
/// chains. Linear in n. The triangles are linked as they are made, strip by strip.
/// @returns nothing where chains touch (equal first coordinates in two columns) or where a triangle
///          would be collinear up to rounding.
std::optional<TorusTriangulation> strip_triangulation(const Points& coordinates,
                                                      const SpatialSort& columns);

}  // namespace pcvt
