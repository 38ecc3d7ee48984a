#pragma once

#include <Eigen/Core>
#include <random>

#include "mesher/plane/delaunay/predicates.hpp"
#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::testing {

/// Weights between 0 and `size` times the mean area of a cell, in units of the Gram matrix.
inline Eigen::VectorXd random_weights(const plane::Sites& sites, double size,
                                      std::mt19937_64& random) {
    const double unit = gram_unit(sites.reduction().reduced);
    const double h = sites.spacing() / unit;
    std::uniform_real_distribution<double> uniform(0, size * (h * h));
    Eigen::VectorXd weights(sites.n_sites());
    for (double& w : weights) w = uniform(random);
    return weights;
}

}  // namespace pcvt::testing
