#pragma once

#include <Eigen/Core>

namespace pcvt::plane {

/// Compares a graded mesh with the asymptotic theory for many sites (A. Gersho 1979; Q. Du, D. Wang
/// 2005): cells are hexagons with a spacing proportional to rho^(-1/4).
///
/// Example usage:
///
///     const GershoScaling scaling = compare_with_gersho_scaling(energy.mass, pass.areas());
///     const double excess = energy.value / scaling.energy - 1;
struct GershoScaling {
    /// Median over the cells of |h_i / l_i - 1|, with h_i = sqrt(area of cell i) and the
    /// theoretical spacing l_i = c rho_i^(-1/4), where rho_i is the mean density of the cell and
    /// c^2 = (integral of rho^(1/2)) / n.
    double median_deviation = 0;
    /// 5 / (18 sqrt(3) n) (integral of rho^(1/2))^2, the asymptotic value of F.
    double energy = 0;
};

/// @param mass, area  of each cell; the integral of rho^(1/2) is computed as the sum of sqrt(mass
///              area).
GershoScaling compare_with_gersho_scaling(const Eigen::VectorXd& mass, const Eigen::VectorXd& area);

}  // namespace pcvt::plane
