#pragma once

#include <random>
#include <string>

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::testing {

/// The initial state of a job.
struct Beginning {
    std::string lattice_kind;
    std::string sites_kind;
    plane::Sites sites;
};

/// A lattice of any kind (square, thin up to 1 : 1000, oblique, skewed, hexagonal, tiny, huge,
/// random) and distinct sites of any kind (random, grid, nearly cocircular, on the seam, on a line,
/// clustered): 60 % with n <= 12, the others up to 2,000, log-uniform.
Beginning any_beginning(std::mt19937_64& random);

}  // namespace pcvt::testing
