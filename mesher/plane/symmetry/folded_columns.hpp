#pragma once

#include <span>

#include "mesher/plane/symmetry/plane_group.hpp"

namespace pcvt::plane {

/// Writes the images of folded_point() for points by columns, with the same bits, vectorised.
///
/// Example usage:
///     fold_columns(group.given_operations(), u, v, n, least_u, least_v);
///
/// @param u, v  lattice coordinates in [0, 1); no array may overlap another one.
void fold_columns(std::span<const LatticeIsometry> operations, const double* u, const double* v,
                  std::size_t n, double* least_u, double* least_v);

}  // namespace pcvt::plane
