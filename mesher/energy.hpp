#pragma once

#include "mesher/periodic_delaunay.hpp"

namespace pcvt {

/// F, its gradient and the masses at one state of the sites, rho = 1.
struct Energy {
    /// F of Eq. 3, length^4.
    double value;
    /// 2 x n, dF/dx_i, length^3.
    Points gradient;
    /// Areas of the cells, length^2.
    Eigen::VectorXd mass;
};

/// The periodic CVT energy and its gradient (paper, Eqs. 2 and 3) for rho = 1.
///
///   F(x)    = sum_i  integral over cell i of  |p - x_i|^2
///   dF/dx_i = 2 m_i (x_i - g_i)
///
/// One pass over the Delaunay triangles, without a circumcentre or a polygon: the part of cell i
/// that belongs to the directed edge (i, j) of a triangle is the right-angled triangle between x_i,
/// the middle of the edge and the circumcentre, signed where the opposite angle is obtuse. The sum
/// is exact on a Delaunay triangulation. Laws, tested by number:
///   (1) F is unchanged when any site moves by a lattice translation.
///   (2) The gradient sums to zero over the sites.
///   (3) F >= 5 A^2 / (18 sqrt(3) n), A the area of the domain.
///   (4) The masses sum to A.
Energy energy(const PeriodicDelaunay& delaunay);

}  // namespace pcvt
