#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesher/base/block_matrix.hpp"
#include "mesher/base/workers.hpp"
#include "mesher/cells/cell_graph.hpp"
#include "mesher/cvt/energy.hpp"
#include "mesher/plane/delaunay/torus_triangulation.hpp"
#include "mesher/plane/geometry/reduced_frame.hpp"

namespace pcvt::plane {

/// A regular triangulation and the data that its power cells depend on.
struct WeightedTriangulation {
    const TorusTriangulation& triangulation;
    /// 2 x n, reduced basis.
    const Points& coordinates;
    /// The frame, in any unit of length.
    ReducedFrame frame;
    /// unit^2
    const Eigen::VectorXd& weights;
};

/// Computes the height of each halfedge's orthocentre above it, over its length, and the areas of
/// the cells of sites with weights w_i: the sets where |p - x_i|^2 - w_i is least.
///
///   symbol | code
///   O      | the orthocentre of a triangle: equal power distance to its corners
///   f      | foot: the fraction of d = x_j - x_i at which edge ij of the diagram crosses its line
///   e      | height: the signed distance of O from side ij over |d|
///   l      | the length of the edge of the diagram, (e + e') |d|
///
/// Each directed side (i, j) of a triangle adds to cell i the right-angled triangle between x_i,
/// the foot and O, with the sign of f e:
///
///   f  =  (|d|^2 + w_i - w_j) / 2 |d|^2
///   e  =  (p_k + (p_j (w_i - w_k) + p_i (w_j - w_k)) / |d|^2) / 2 A
///   m_i += f e |d|^2 / 2      first moment += f^2 e |d|^2 d / 3 + f e^2 |d|^2 d' / 6
///
/// with d' = d rotated by +90 degrees, k the third corner, p the scalar product of the two sides at
/// a corner and A their cross product, twice the area. Without weights f = 1/2 and e is half of the
/// cotangent at k, and the sums are those of energy.hpp.
///
/// Example usage:
///
///     std::vector<double> heights;
///     Eigen::VectorXd mass;
///     measure_masses(regular, workers, heights, mass);
///     Energy cells;
///     measure_cells(regular, heights, workers, cells);
///     const Vec2 to_centroid = -cells.gradient.segment<2>(2 * i) / (2 * cells.mass[i]);
///
/// Laws, tested by number:
///   (1) Masses, gradient and energy are those of the polygons, also in thin triangles.
///   (2) The masses sum to the area of the domain.
///   (3) The derivative of the masses by the weights is minus the Laplacian of the graph.
///   (4) Every bit is the same for any number of workers.
///   (5) assemble_moment_derivatives() has the derivatives of areas and first moments.
///
/// @param heights  resized to the number of halfedges, dimensionless.
/// @param mass     resized to n, unit^2.
void measure_masses(const WeightedTriangulation& regular, Workers& workers,
                    std::vector<double>& heights, Eigen::VectorXd& mass);

/// Computes energy, gradient and areas of the power cells for rho = 1, cell by cell.
/// @param heights  of measure_masses.
void measure_cells(const WeightedTriangulation& regular, const std::vector<double>& heights,
                   Workers& workers, Energy& cells);

/// Computes the adjacency of the cells.
/// @param heights  of measure_masses.
void assemble_cell_graph(const WeightedTriangulation& regular, const std::vector<double>& heights,
                         Workers& workers, CellGraph& graph);

/// Assembles the derivatives of the moments of the cells by their sites and weights. With r = p -
/// x, u_i = w_i / 2, a side moves at p along d = x_j - x_i by
///
///   v  =  (r_i.dx_i + du_i - r_j.dx_j - du_j) / |d|
///
/// so that the changes of the first moment and of the area of cell i are the sums over its sides of
/// the integrals of r_i v and of v, and the matrix is symmetric and positive semidefinite.
///
/// @param heights  of measure_masses.
/// @param unit     u is scaled to the numbers u / unit, a length.
/// @param matrix   rows 2 i: x_i; rows 2 i + 1: u_i / unit, and a number that is coupled to none.
void assemble_moment_derivatives(const WeightedTriangulation& regular,
                                 const std::vector<double>& heights, double unit,
                                 BlockMatrix& matrix);

}  // namespace pcvt::plane
