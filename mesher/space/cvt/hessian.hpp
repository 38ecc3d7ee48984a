#pragma once

#include "mesher/base/block_matrix.hpp"
#include "mesher/space/delaunay/torus_tetrahedra.hpp"
#include "mesher/space/energy/tetrahedron_terms.hpp"

namespace pcvt::space {

/// The exact Hessian of the periodic CVT energy in space (M. Iri, K. Murota, T. Ohya 1984; Y. Liu
/// et al. 2009), in a Frame and its unit: unit^3.
///
///   H_ij  =  2 / |x_j - x_i| integral over the facet of (p - x_i) (p - x_j)^T
///   H_ii  =  - sum H_ij, because F does not change under translations
///
/// The facet between x_i and x_j consists of two triangles for each tetrahedron at the edge ij:
/// from the middle m of the edge to the circumcentre Phi of a face ijk of the tetrahedron and to
/// the circumcentre C of the tetrahedron. With d = x_j - x_i, u = Phi - m, v = C - m, s = u + v, D
/// = (x_i - x_k).(x_j - x_k), and the height q of C over the face in units of its normal, a
/// triangle adds
///
///   D q / 2 ((u u^T + v v^T + s s^T) / 12 + (d s^T - s d^T) / 6 - d d^T / 4)
///
/// where D q / 2 is 2 / |d| times its area, with its sign. An edge between images of one site adds
/// nothing.
///
/// Site s has the rows 2 s, for x and y, and 2 s + 1, for z and a variable that is not used, whose
/// diagonal entry is twice the mean volume of a cell.
///
/// Example usage:
///
///     BlockMatrix hessian;
///     assemble_hessian(moving.tetrahedra(), moving.coordinates(), moving.frame(), hessian);
///
/// Laws, tested by number:
///   (1) It is the derivative of the gradient (energy.hpp), with off-diagonal blocks rounded
///       to single precision.
///   (2) It is symmetric to the last bit.
///   (3) Translations are null vectors, except for rounding.
///
/// @param coordinates  of the reduced basis; the tetrahedra are the Delaunay triangulation.
void assemble_hessian(const TorusTetrahedra& tetrahedra, const Points& coordinates,
                      const Frame& frame, BlockMatrix& hessian);

}  // namespace pcvt::space
