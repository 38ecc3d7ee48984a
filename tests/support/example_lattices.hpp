#pragma once

#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt::testing {

/// The unit square, and an oblique lattice whose numbers are not exact.
inline const plane::Lattice kSquare({1, 0}, {0, 1});
inline const plane::Lattice kOblique({1, 0}, {0.37, 0.81});

}  // namespace pcvt::testing
