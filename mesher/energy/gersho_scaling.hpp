#pragma once

#include <Eigen/Core>

namespace pcvt {

/// How a graded mesh compares with what theory says of many sites (A. Gersho 1979; Q. Du, D. Wang
/// 2005): cells are hexagons whose spacing goes with rho^(-1/4).
struct GershoScaling {
    /// Median over the cells of |h_i / l_i - 1|, h_i = sqrt(area of cell i), and l_i the law's:
    /// c rho_i^(-1/4), rho_i the mean density of the cell, c^2 = (integral of rho^(1/2)) / n.
    double median_deviation = 0;
    /// 5 / (18 sqrt(3) n) (integral of rho^(1/2))^2: what F tends to.
    double energy = 0;
};

/// @param mass, area  of each cell; the integral of rho^(1/2) is taken as the sum of
///                    sqrt(mass area).
GershoScaling compare_with_gersho_scaling(const Eigen::VectorXd& mass, const Eigen::VectorXd& area);

}  // namespace pcvt
