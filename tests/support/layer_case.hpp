#pragma once

#include <vector>

#include "io/openfoam/foam_layer.hpp"
#include "io/openfoam/foam_writer.hpp"

namespace pcvt::testing {

/// The files of the case t.foam of a tile.
inline std::vector<EncodedFile> layer_case(const plane::Tile& tile, double thickness = 0,
                                           const CellMaterials* materials = nullptr) {
    return encode_foam(foam_case(tile, extruded_mesh(tile, thickness), materials), "t.foam");
}

}  // namespace pcvt::testing
