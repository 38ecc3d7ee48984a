#pragma once

#include "mesher/plane/tile/tile.hpp"

namespace pcvt::plane {

/// Whether two tiles have one lattice, one list of positions, number for number, and the same
/// faces: each with its corners in order, from the same first one, the faces in any order, and the
/// same sites, unless one of the tiles has none. Where they do, each law of a tile (validate.hpp)
/// holds for both or for neither.
///
/// Cost: O(n).
bool same_geometry(const Tile& s, const Tile& t);

}  // namespace pcvt::plane
