#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "mesher/plane/power/power_mirrors.hpp"

namespace pcvt::testing {

/// Weights from 0 to `size` times the mean area of a cell, length^2.
inline Eigen::VectorXd drawn_weights(const plane::Lattice& lattice, Eigen::Index n, double size,
                                     std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform(0, size * lattice.area() / double(n));
    Eigen::VectorXd weights(n);
    for (double& w : weights) w = uniform(random);
    return weights;
}

/// The sites that a power diagram of copies of all sites lacks.
/// @param weights  length^2.
/// @param diagram  power_copies() or power_mirrors().
inline std::vector<SiteId> lacking_sites(
    const plane::Sites& sites, const Eigen::VectorXd& weights,
    plane::PowerMirrors (*diagram)(const plane::Sites&,
                                   const Eigen::VectorXd&) = plane::power_copies) {
    const double unit = gram_unit(sites.reduction().reduced);
    std::vector<bool> has_cell(std::size_t(sites.n_sites()), false);
    for (const plane::Triangle& triangle : diagram(sites, weights / (unit * unit)).triangles) {
        for (const plane::Corner& corner : triangle) has_cell[std::size_t(corner.site)] = true;
    }
    std::vector<SiteId> lacking;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        if (!has_cell[std::size_t(s)]) lacking.push_back(s);
    }
    return lacking;
}

}  // namespace pcvt::testing
