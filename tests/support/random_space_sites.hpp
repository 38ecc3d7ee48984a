#pragma once

#include <random>
#include <string>

#include "mesher/space/geometry/sites.hpp"

namespace pcvt::testing {

struct RandomSpaceSites {
    /// The kind of lattice, the kind of sites and their number.
    std::string name;
    space::Sites sites;
};

/// Draws a lattice (cube, box, oblique, unreduced, left-handed, thin 1 : 100, close-packed) and
/// 1 to 300 distinct sites on it: random ones, rows, planes, grids, cubic lattices (exact, or off
/// by 2^-50), cospherical sites, clusters, and sites on the seam.
RandomSpaceSites random_space_sites(std::mt19937_64& random);

}  // namespace pcvt::testing
