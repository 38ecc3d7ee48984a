#pragma once

#include <string>

#include "mesher/density/density.hpp"

namespace pcvt::cli {

/// The density of --density and --density-range.
///
///   job.density = density_option("1 + 9 * u", "", job.lattice);
///
/// @param range    empty if the option is not given.
/// @param lattice  defines the coordinates u and v.
/// @throws InvalidInput, BadFile, BadDensity naming the options; LimitExceeded.
Density density_option(const std::string& density, const std::string& range,
                       const Lattice& lattice);

}  // namespace pcvt::cli
