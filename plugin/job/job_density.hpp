#pragma once

#include <optional>
#include <string>

#include "io/run_files/density_image.hpp"

namespace pcvt {

/// Whether a density's source is the name of a picture, and not a formula: ends in .png, in any
/// case.
bool names_picture(const std::string& source);

/// The density of a source: a formula, with its jumps along u and v found, or a .png file.
/// @param range    of a picture; nothing: the default.
/// @param lattice  whose coordinates u and v are.
/// @throws InvalidInput  a range for a formula, or one that is not positive and in the limits of
///                       densities; what expression_density, png_density and with_axis_breaks
///                       throw.
Density source_density(const std::string& source, const std::optional<GreyRange>& range,
                       const Lattice& lattice);

}  // namespace pcvt
