#pragma once

#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/cells/cell_materials.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Returns the paths of the files in the case folder `folder`, in the order of encode_foam().
std::vector<std::string> foam_paths(const std::string& folder);

/// Encodes a tile as a case folder for OpenFOAM that icoFoam, pimpleFoam, potentialFoam and
/// scalarTransportFoam run without further input: one layer of cells with a pair of cyclic patches
/// for each translation, a wall patch for each wall, empty patches at back and front, and a
/// CellFlow as the initial state, which falls to 1/e by the end of the run. An empty file with the
/// name of the folder opens the case in ParaView.
///
/// Cell i is face i of the tile; in a tile of cells without repetition it is the cell of site i.
/// Comments in the boundary file hold the kind of the faces, the period vectors, the site of each
/// cell, the notes of the sites (io/tiles/site_notes.hpp) and the phases. The cells of each phase
/// are the zone phase_NAME.
///
/// Example usage:
///     OutputSet output;
///     output.stage_folder("tile.foam");
///     for (const EncodedFile& file : encode_foam(tile, "tile.foam")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @param thickness  of the layer, length units; 0: as extruded_mesh() chooses it.
/// @param materials  of the sites of one period, for faces that have sites; null: none.
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_foam(const plane::Tile& tile, const std::string& folder,
                                     double thickness = 0,
                                     const CellMaterials* materials = nullptr);

}  // namespace pcvt
