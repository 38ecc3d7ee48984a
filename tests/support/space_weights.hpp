#pragma once

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "mesher/space/delaunay/power_predicates.hpp"
#include "tests/support/random_numbers.hpp"

namespace pcvt::testing {

/// Weights between 0 and `size` h^2, length^2.
inline Eigen::VectorXd random_space_weights(const space::Sites& sites, double size,
                                            std::mt19937_64& random) {
    const double h = sites.spacing();
    Eigen::VectorXd weights(sites.n_sites());
    for (double& w : weights) w = size * h * h * random_number(random);
    return weights;
}

/// Weights in the unit of the predicates.
/// @param weights  length^2.
inline Eigen::VectorXd gram_weights(const space::Sites& sites, const Eigen::VectorXd& weights) {
    const double unit = gram_unit(sites.reduction().reduced);
    Eigen::VectorXd of_gram = weights / (unit * unit);
    for (double& w : of_gram) w = space::rounded_weight(w);
    return of_gram;
}

/// Volumes whose equivalent diameters have a lognormal law, with the sum of the domain.
/// @param spread  standard deviation over mean of the diameters.
inline Eigen::VectorXd lognormal_volumes(int n, double spread, double total,
                                         std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    Eigen::VectorXd volumes(n);
    for (double& v : volumes)
        v = std::exp(3 * std::sqrt(std::log1p(spread * spread)) * normal(random));
    const double least = 1e-6 * volumes.mean();
    for (double& v : volumes) v = std::max(v, least);
    return volumes * (total / volumes.sum());
}

}  // namespace pcvt::testing
