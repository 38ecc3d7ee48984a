#pragma once

#include <optional>
#include <string>

#include "io/density_image.hpp"

namespace pcvt {

/// Whether a density's source is a picture, and not a formula.
bool names_picture(const std::string& source);

/// The density of a source: a formula, or the name of a .png file.
/// @param range  of a picture; nothing: the default.
/// @throws InvalidInput  a range for a formula, or one that is not positive and in the limits of
///                       densities; what expression_density and png_density throw.
Density source_density(const std::string& source, const std::optional<GreyRange>& range);

}  // namespace pcvt
