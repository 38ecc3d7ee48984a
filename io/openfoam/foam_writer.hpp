#pragma once

#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// The files of the case folder `folder`, in the order in which encode_foam fills them.
std::vector<std::string> foam_paths(const std::string& folder);

/// A case folder for OpenFOAM that runs with icoFoam as it is: the tile as one layer of cells with
/// a pair of cyclic patches for each translation, empty back and front, and a DecayingFlow to start
/// from, which at the end of the run has fallen to 1/e.
///
/// Cell i is face i of the tile, so in a tile of cells that was not repeated the cell of site i.
/// Comments in the boundary file keep the kind of the faces and the period vectors.
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_foam(const Tile& tile, const std::string& folder);

}  // namespace pcvt
