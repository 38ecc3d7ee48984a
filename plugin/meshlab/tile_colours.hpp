#pragma once

#include <pcvt.h>
#include <vcg/space/color4.h>

#include <vector>

#include "plugin/meshlab/tile_request.hpp"

namespace pcvt::meshlab {

/// A colour for each site. By sides it is that of the command's own files; edges count as sides
/// that are longer than 1e-5 h and than options.short_edges h, h = sqrt(area / sites).
/// @returns nothing for Colouring::kNone.
/// @throws std::runtime_error where pcvt refuses.
std::vector<vcg::Color4b> site_colours(const pcvt_result* result, const TileRequest& request);

}  // namespace pcvt::meshlab
