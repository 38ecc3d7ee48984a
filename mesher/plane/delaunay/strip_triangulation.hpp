#pragma once

#include <optional>

#include "mesher/plane/delaunay/spatial_sort.hpp"
#include "mesher/plane/delaunay/torus_triangulation.hpp"

namespace pcvt::plane {

/// Builds a triangulation of the torus, Delaunay or not, for any n >= 1: the start for Lawson's
/// flips.
///
/// The sites of a column, joined in order, form a chain that closes round the torus and is monotone
/// in the coordinate along the columns. The annular strip between two neighbouring chains is
/// triangulated as a monotone polygon (M. Garey et al. 1978), cut open along one edge between the
/// chains. The cost is linear in n; triangles are linked as they are made, strip by strip.
/// @returns nullopt where chains touch (equal coordinates across two columns) or where a triangle
///          would be collinear up to rounding.
std::optional<TorusTriangulation> strip_triangulation(const Points& coordinates,
                                                      const SpatialSort& columns);

}  // namespace pcvt::plane
