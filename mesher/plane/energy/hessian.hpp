#pragma once

#include "mesher/base/block_matrix.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"

namespace pcvt::plane {

/// The exact Hessian of the periodic CVT energy for rho = 1 (M. Iri, K. Murota, T. Ohya 1984; Y.
/// Liu et al. 2009), in the frame, the unit and the numbering of `delaunay`: unit^2.
///
///   paper | code
///   H_ij  | BlockMatrix::block, the entry of row i with column j
///   H_ii  | BlockMatrix::diagonal
///   x_i   | MovingDelaunay::coordinates
///
/// The Voronoi edge between x_i and an image x_j moves along its normal with the speed ((p -
/// x_i).dx_i - (p - x_j).dx_j) / |x_j - x_i| at p. The derivative of dF/dx_i = 2 integral over cell
/// i of (x_i - p) is therefore, summed over the edges of cell i,
///
///   H_ij  =  2 / |x_j - x_i| integral over the edge of (p - x_i) (p - x_j)^T
///   H_ii  =  2 m_i 1 - sum 2 / |x_j - x_i| integral over the edge of (p - x_i) (p - x_i)^T
///
/// With d = x_j - x_i, d' = d rotated by +90 degrees and l = |d|^2, the edge runs from x_i + (d -
/// c' d') / 2 to x_i + (d + c d') / 2, where c and c' are the cotangents opposite to d in the
/// triangles to its left and right, and the first integral is
///
///   H_ij  =  e (-d d^T / 4 + q d' d'^T / 12 + (c - c') (d d'^T - d' d^T) / 8)
///   e = c + c',  q = c^2 - c c' + c'^2
///
/// Where two edges join the same two sites the row has two entries; an edge between images of one
/// site adds nothing. F does not change under translations, so H_ii = - sum H_ij, which is the
/// formula used. F is twice continuously differentiable where no two sites coincide; in particular
/// the Hessian is continuous where an edge flips.
///
/// Example usage:
///
///     BlockMatrix hessian;
///     assemble_hessian(delaunay, workers, hessian);
///     const Minimum minimum = stability(hessian);
///
/// Laws, tested by number:
///   (1) It is the derivative of the gradient (energy.hpp), with off-diagonal blocks rounded to
///       single precision.
///   (2) H_ji is H_ij^T, and H_ii is symmetric, to the last bit.
///   (3) The blocks of a row sum to zero, except for the rounding of their antisymmetric parts.
///
/// @param delaunay  restored and, if it was moved, settled.
void assemble_hessian(const MovingDelaunay& delaunay, Workers& workers, BlockMatrix& hessian);

}  // namespace pcvt::plane
