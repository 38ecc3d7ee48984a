#pragma once

#include <random>
#include <string>

#include "mesher/space/energy/energy_pass.hpp"

namespace pcvt::testing {

/// A direction for MovingTetrahedra::step, by which t = 1 reaches the goal up to rounding to single
/// precision.
struct NamedSpaceMove {
    std::string name;
    Eigen::VectorXf direction;
};

/// Noise of any size, a drift, jumps by periods, jumps of some sites to any place, moves onto the
/// points of a grid, exchanges of two sites and meetings of two, and a step of Lloyd's method.
/// @param energy  at the current positions.
NamedSpaceMove random_space_move(const space::MovingTetrahedra& moving, const Energy& energy,
                                 std::mt19937_64& random);

}  // namespace pcvt::testing
