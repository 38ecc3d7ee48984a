#include "mesher/plane/energy/gersho_scaling.hpp"

#include <algorithm>
#include <cmath>

namespace pcvt::plane {

GershoScaling compare_with_gersho_scaling(const Eigen::VectorXd& mass,
                                          const Eigen::VectorXd& area) {
    const auto n = static_cast<double>(mass.size());
    // area_i rho_i^(1/2), which is the same for all cells if the law holds.
    Eigen::VectorXd share = (mass.array() * area.array()).sqrt();
    const double root_integral = share.sum();
    for (double& s : share) s = std::abs(std::sqrt(s * n / root_integral) - 1);
    const auto middle = share.begin() + share.size() / 2;
    std::nth_element(share.begin(), middle, share.end());
    return {*middle, 5 / (18 * std::sqrt(3.0) * n) * root_integral * root_integral};
}

}  // namespace pcvt::plane
