#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::testing {

struct NamedLattice {
    std::string name;
    plane::Lattice lattice;
};

/// Square, thin, tiny, huge, oblique, skewed, left-handed and hexagonal lattices.
inline std::vector<NamedLattice> lattices() {
    return {{"square", plane::Lattice::rectangle(1, 1)},
            {"wide", plane::Lattice::rectangle(20, 1)},
            {"tall", plane::Lattice::rectangle(1, 20)},
            {"tiny", plane::Lattice::rectangle(0.001, 0.002)},
            {"huge", plane::Lattice::rectangle(1e6, 1e6)},
            {"oblique", plane::Lattice({1, 0}, {0.37, 0.81})},
            {"skewed", plane::Lattice({1, 0}, {7, 1})},
            {"turned", plane::Lattice({0.5, 0.1}, {-0.2, 2})},
            {"left-handed", plane::Lattice({0.3, 1.1}, {1, 0.2})},
            {"hexagonal", plane::Lattice({1, 0}, {0.5, std::sqrt(0.75)})}};
}

/// Two normally distributed vectors; the second is sometimes much longer or nearly parallel to the
/// first.
inline plane::Lattice random_lattice(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    for (;;) {
        const plane::Vec2 a{normal(random), normal(random)};  // Braces give the draws an order.
        const plane::Vec2 c{normal(random), normal(random)};
        const double stretch = std::exp(normal(random));
        const plane::Vec2 b = stretch * c + std::floor(3 * normal(random)) * a;
        if (std::abs(a.x() * b.y() - a.y() * b.x()) > 0.01 * a.norm() * c.norm()) return {a, b};
    }
}

}  // namespace pcvt::testing
