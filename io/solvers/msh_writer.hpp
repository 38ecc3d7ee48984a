#pragma once

#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// Gmsh MSH 4.1, ASCII, double precision: triangles, of six nodes for order 2, with their
/// periodicity.
///
/// Node v + 1 is vertex v, element f + 1 is face f; line elements follow. Entities: a curve for
/// each boundary run, a point where two runs meet, one surface; a node stands in the block of the
/// entity that it lies on. Physical groups: `seam_I_J`, the curves that I a + J b takes to their
/// partners, and `tile`, the surface. $Periodic holds each curve and point that is not a master:
/// slave = master + translation. $ElementData "cell_id" is that of element_cells() on triangles,
/// -1 on lines; $NodeData "cell_id" the site of each node where the tile has one. $Comments hold
/// the lattice.
/// @throws InvalidInput   the tile has polygons.
/// @throws InternalError  a coordinate is not finite.
std::vector<EncodedFile> encode_msh(const Tile& tile, const std::string& path);

}  // namespace pcvt
