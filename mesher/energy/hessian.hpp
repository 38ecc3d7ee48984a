#pragma once

#include "mesher/base/block_matrix.hpp"
#include "mesher/delaunay/moving_delaunay.hpp"

namespace pcvt {

/// The exact Hessian of the periodic CVT energy for rho = 1 (M. Iri, K. Murota, T. Ohya 1984; Y.
/// Liu et al. 2009), in the frame, the unit and the numbering of `delaunay`: unit^2.
///
/// The Voronoi edge between x_i and an image x_j moves along its normal with the speed
/// ((p - x_i).dx_i - (p - x_j).dx_j) / |x_j - x_i| at p; under the integral of dF/dx_i = 2 integral
/// over cell i of (x_i - p) this gives, summed over the edges of cell i,
///
///   H_ij  =  2 / |x_j - x_i| integral over the edge of (p - x_i) (p - x_j)^T
///   H_ii  =  2 m_i 1 - sum 2 / |x_j - x_i| integral over the edge of (p - x_i) (p - x_i)^T
///
/// With d = x_j - x_i, d' = d turned by +90 degrees and l = |d|^2, the edge runs from
/// x_i + (d - c' d') / 2 to x_i + (d + c d') / 2, where c is the cotangent opposite to d in the
/// triangle on its left and c' in that on its right, and the first integral is
///
///   H_ij  =  e (-d d^T / 4 + q d' d'^T / 12 + (c - c') (d d'^T - d' d^T) / 8)
///   e = c + c',  q = c^2 - c c' + c'^2
///
/// Where two edges join the same two sites both are entries of the row; an edge between images of
/// one site adds nothing. F does not change under translations, so H_ii = - sum H_ij, which is how
/// it is computed. F is twice continuously differentiable where no two sites coincide: the Hessian,
/// too, does not jump where an edge flips. Laws, tested by number:
///   (1) It is the derivative of the gradient (energy.hpp), rounded to single precision beside the
///       diagonal.
///   (2) H_ji is H_ij^T, and H_ii is symmetric, to the last bit.
///   (3) The blocks of a row sum to zero, but for the rounding of their antisymmetric parts.
///
/// @param delaunay  restored and, where it was moved, settled.
void assemble_hessian(const MovingDelaunay& delaunay, Workers& workers, BlockMatrix& hessian);

}  // namespace pcvt
