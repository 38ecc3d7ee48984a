#pragma once

#include <optional>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {

/// The tile at the back of an OpenFOAM case one cell thick, with the pairs of edges that its cyclic
/// patches state. Of `files` those of constant/polyMesh are read, wherever they stand in the list.
/// @param lattice  stands in for the comment `pcvt lattice` that a boundary file of another program
///                 lacks.
/// @throws BadFile  a file is missing or is not what OpenFOAM calls ASCII.
/// @throws NotATile the mesh breaks the laws of ExtrudedMesh.
TileFile decode_foam(const std::vector<EncodedFile>& files, const std::optional<Lattice>& lattice);

}  // namespace pcvt
