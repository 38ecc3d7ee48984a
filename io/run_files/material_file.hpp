#pragma once

#include <string>
#include <string_view>

#include "io/bytes/bad_file.hpp"
#include "mesher/cells/elastic_choices.hpp"

namespace pcvt {

/// Adds the materials of a file in the form of DAMASK 3:
///
///     phase:
///       NAME:
///         mechanical:
///           elastic: {type: Hooke, C_11: 106.9e9, C_12: 60.5e9, C_44: 28.4e9}
///
/// The constants are C_11, C_12, C_44 of cubic crystals; C_11, C_12, C_13, C_33, C_44 of hexagonal
/// ones with the axis z; or, which DAMASK does not know, E and nu. Coefficients of the temperature
/// (C_11,T) are left out. A material with other constants is refused only where a phase needs it.
/// @throws BadFile with the line for a file of another form.
void add_material_file(const std::string& name, std::string_view text, ElasticChoices& choices);

}  // namespace pcvt
