#pragma once

#include "io/gltf/space_gltf.hpp"

namespace pcvt {

/// Proves the sites of cells, within the rounding of single precision: the site of each cell,
/// mirrored in any face of the cell, is an image of a site. Of power cells, each face lies at the
/// place of another one, turned over, and in the plane that the sites and the weights of the two
/// cells give.
/// @param largest  the largest coordinate of a corner.
/// @throws NotATile naming the cell.
void compare_sites(const GlbSurfaces& glb, double largest);

}  // namespace pcvt
