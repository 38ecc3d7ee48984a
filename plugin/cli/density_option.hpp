#pragma once

#include <string>

#include "mesher/density/density.hpp"

namespace pcvt::cli {

/// The density that --density and --density-range ask for.
/// @param range    empty where it was not given.
/// @param lattice  whose coordinates u and v are.
/// @throws InvalidInput, BadFile, BadDensity in the words of the user; LimitExceeded.
Density density_option(const std::string& density, const std::string& range,
                       const Lattice& lattice);

}  // namespace pcvt::cli
