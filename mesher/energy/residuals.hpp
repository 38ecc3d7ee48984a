#pragma once

#include <Eigen/Core>

#include "mesher/base/workers.hpp"

namespace pcvt {

/// Of the residuals |x_i - g_i| / h.
struct Residuals {
    double largest;
    double rms;
};

/// From gradients of the energy: dF/dx_i = 2 m_i (x_i - g_i). The same bits for any number of
/// workers.
/// @param gradient  x, y, x, y, ...
/// @param spacing   h.
Residuals residuals(const Eigen::VectorXd& gradient, const Eigen::VectorXd& mass, double spacing,
                    Workers& workers);

}  // namespace pcvt
