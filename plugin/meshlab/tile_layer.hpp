#pragma once

#include <common/meshmodel.h>
#include <pcvt.h>

#include <vector>

#include "plugin/meshlab/tile_request.hpp"

namespace pcvt::meshlab {

/// Fills an empty layer with a tile. Laws, tested by number:
///   (1) Vertices are those of the tile, rounded to 32 bits; a face of k corners is k - 2 triangles
///       in a row, round its first corner, with hidden (faux) edges between them.
///   (2) The quality of a vertex is its orbit, or of Delaunay triangles its site: two vertices have
///       the same quality if and only if they are glued. The quality of a face is its site.
///   (3) Faces, or vertices of Delaunay triangles, have the colours of their sites.
///   (4) The selection is that of the request.
///
/// @param colours  of the sites; empty: white.
void fill_layer(MeshModel& layer, const pcvt_tile& tile, const std::vector<vcg::Color4b>& colours,
                const TileRequest& request);

}  // namespace pcvt::meshlab
