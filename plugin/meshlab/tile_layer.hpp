#pragma once

#include <common/meshmodel.h>
#include <pcvt.h>

#include <vector>

#include "plugin/meshlab/tile_request.hpp"

namespace pcvt::meshlab {

/// Fills an empty layer with a tile. Laws, tested by number:
///   (1) Vertices are those of the tile, rounded to 32 bits; a face of k corners is k - 2 triangles
///       in a row, round its first corner, with hidden (faux) edges between them.
///   (2) The quality of a vertex is its orbit, or of Delaunay triangles its site: it is the same
///       for two vertices just where they are glued. The quality of a face is its site.
///   (3) The colours of faces, or of the vertices of Delaunay triangles, are those of their sites.
///   (4) What is selected is what the request asks for, and nothing else.
///
/// @param colours  of the sites; empty: white.
void fill_layer(MeshModel& layer, const pcvt_tile& tile, const std::vector<vcg::Color4b>& colours,
                const TileRequest& request);

}  // namespace pcvt::meshlab
