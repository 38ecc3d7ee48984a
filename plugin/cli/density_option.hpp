#pragma once

#include <string>

#include "mesher/density.hpp"

namespace pcvt::cli {

/// Whether the value of --density is the name of a picture: ends in .png, in any case.
bool names_picture(const std::string& density);

/// The density that --density and --density-range ask for.
/// @param range    empty where it was not given.
/// @param lattice  whose coordinates u and v are.
/// @throws InvalidInput, BadFile, BadDensity in the words of the user; LimitExceeded.
Density density_option(const std::string& density, const std::string& range,
                       const Lattice& lattice);

}  // namespace pcvt::cli
