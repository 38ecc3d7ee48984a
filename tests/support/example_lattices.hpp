#pragma once

#include "mesher/lattice/lattice.hpp"

namespace pcvt::testing {

/// The unit square, and an oblique lattice whose numbers are not exact.
inline const Lattice kSquare({1, 0}, {0, 1});
inline const Lattice kOblique({1, 0}, {0.37, 0.81});

}  // namespace pcvt::testing
