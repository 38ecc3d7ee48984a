#pragma once

#include "mesher/density/density.hpp"

namespace pcvt {

/// The density with those of its jumps as break lines that lie along u = const or v = const: seen
/// on several probe lines across, and bisected to the last digits. Jumps along other curves, jumps
/// nearer to each other than 1/512, and kinks are not found.
/// Cost: some 10^4 evaluations.
/// @throws BadDensity naming the place.
Density with_axis_breaks(const Lattice& lattice, Density density);

}  // namespace pcvt
