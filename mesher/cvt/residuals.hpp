#pragma once

#include <Eigen/Core>

#include "mesher/base/workers.hpp"

namespace pcvt {

/// Maximum and root mean square of the residuals |x_i - g_i| / h.
struct Residuals {
    double largest;
    double rms;
};

/// Computes the residuals from the gradient of the energy, dF/dx_i = 2 m_i (x_i - g_i), in the
/// plane or in space; bit for bit the same for any number of workers.
///
/// Example usage:
///
///     const auto [largest, rms] = residuals(energy.gradient, energy.mass, spacing, workers);
///
/// @param gradient  as in Energy: 2 or 4 numbers a site.
/// @param spacing   h.
Residuals residuals(const Eigen::VectorXd& gradient, const Eigen::VectorXd& mass, double spacing,
                    Workers& workers);

/// Computes the steps g_i - x_i of Lloyd's iteration from the same gradient, in single precision.
/// @param steps  as the gradient; gets its length here.
void steps_to_centroids(const Eigen::VectorXd& gradient, const Eigen::VectorXd& mass,
                        Eigen::VectorXf& steps);

}  // namespace pcvt
