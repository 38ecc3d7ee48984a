#pragma once

#include <optional>
#include <string>

#include "io/run_files/density_image.hpp"

namespace pcvt {

/// Whether a density's source names a picture, and is not a formula: whether it ends in .png, in
/// upper or lower case.
bool names_picture(const std::string& source);

/// The density of a source: a .png file, or a formula, whose jumps along u and v are located.
///
///   job.density = source_density("1 + 9 * exp(-((v - 0.5) / 0.1)^2)", {}, job.in_plane().lattice);
///
/// @param range    densities of black and white pixels; `nullopt`: the default.
/// @param lattice  defines the coordinates u and v.
/// @throws InvalidInput  a range for a formula, or one outside of the limits of densities; also
/// what
///                       expression_density, png_density and with_axis_breaks throw.
plane::Density source_density(const std::string& source, const std::optional<GreyRange>& range,
                              const plane::Lattice& lattice);

}  // namespace pcvt
