#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace pcvt::space {

/// Coordinates of a vector of a lattice, in units of the metric that measures it.
using LatticeVector = Eigen::Matrix<std::int64_t, 3, 1>;

/// Four vectors of a lattice of space, any three of which span it, whose sum is zero and whose
/// scalar products are not positive: Selling's reduction. The Selling parameters are the scalar
/// products with the sign changed.
///
/// Example usage:
///   const Eigen::Matrix3d metric = basis.transpose() * basis;
///   const auto vectors = obtuse_superbase({LatticeVector::UnitX(), LatticeVector::UnitY(),
///                                          LatticeVector::UnitZ()}, metric);
///   const double g = second_moment(vectors, metric / portable_cbrt(metric.determinant()));
///
/// Law, tested by number:
///   (1) No scalar product exceeds 1e-12 of the longest square.
///
/// @throws InvalidInput if the vectors are dependent up to rounding.
std::array<LatticeVector, 4> obtuse_superbase(std::array<LatticeVector, 3> basis,
                                              const Eigen::Matrix3d& metric);

/// Returns the dimensionless second moment per dimension of the Voronoi cell of a lattice,
/// (S1 + 2 S2 + K) / 36, where S1 is the sum of the Selling parameters p, S2 the sum of their
/// products over the three cycles of length four, and K the sum over the vectors i of
/// p_ij p_ik p_il (p_jk + p_jl + p_kl).
/// @param metric  scaled so that the volume of the cell is 1.
double second_moment(const std::array<LatticeVector, 4>& superbase, const Eigen::Matrix3d& metric);

}  // namespace pcvt::space
