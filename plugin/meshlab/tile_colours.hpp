#pragma once

#include <pcvt.h>
#include <vcg/space/color4.h>

#include <vector>

#include "plugin/meshlab/tile_request.hpp"

namespace pcvt::meshlab {

/// A colour for each site. Colours by sides are those of the command's files; edges count as sides
/// if they are longer than 1e-5 h and than options.short_edges h, h = sqrt(area / sites).
///
///   const std::vector<vcg::Color4b> colours = site_colours(result, request);
///   fill_layer(layer, tile, colours, request);
///
/// @returns an empty vector for Colouring::kNone.
/// @throws std::runtime_error with the message of an error of pcvt.
std::vector<vcg::Color4b> site_colours(const pcvt_result* result, const TileRequest& request);

}  // namespace pcvt::meshlab
