#pragma once

#include <Eigen/Core>

namespace pcvt {

/// F, its gradient and the masses of the cells at given positions of the sites, in D dimensions; in
/// the frame and the unit of a moving triangulation, sites in its order. Energy passes
/// and power cells compute it.
///
///   F(x)    = sum_i  integral over cell i of  rho(p) |p - x_i|^2
///   dF/dx_i = 2 m_i (x_i - g_i)
///
/// with g_i the centroid of cell i (paper, Eqs. 2 and 3, for any number of dimensions). Units are
/// those for rho = 1; a density multiplies them by its own unit.
struct Energy {
    /// F, unit^(D + 2).
    double value = 0;
    /// dF/dx_i, unit^(D + 1): `Moving::kNumbersPerSite` numbers a site, of which the first D count
    /// and the others are zero.
    Eigen::VectorXd gradient;
    /// Masses of the cells, for rho = 1 their areas or volumes, unit^D.
    Eigen::VectorXd mass;
};

}  // namespace pcvt
