#pragma once

#include <array>
#include <cstdint>

#include "mesher/cells/cell_materials.hpp"

namespace pcvt {

/// The colour of a cubic crystal in the inverse pole figure along the axis z of the sample, red,
/// green and blue from 0 to 255: red where z is parallel to an axis <001> of the crystal, green to
/// <011>, blue to <111>. Turns of the crystal that are symmetries of a cube keep it.
///
/// Example usage:
///   const auto [red, green, blue] = pole_colour({45, 0, 0});  // 255, 0, 0
std::array<std::uint8_t, 3> pole_colour(const BungeAngles& angles);

}  // namespace pcvt
