#pragma once

#include "mesher/plane/density/density.hpp"

namespace pcvt::plane {

/// Returns the density with its jumps along u = const or v = const as break lines. Jumps are
/// detected on several probe lines across them and bisected to the last digits. Jumps along other
/// curves, jumps closer to each other than 1/512, and kinks are not found. The cost is about 10^4
/// evaluations.
///
/// Example usage:
///
///     const Density cut = with_axis_breaks(lattice, density);
///     const std::size_t n_lines = cut.u_breaks.size() + cut.v_breaks.size();
///
/// @throws BadDensity naming the point.
Density with_axis_breaks(const Lattice& lattice, Density density);

}  // namespace pcvt::plane
