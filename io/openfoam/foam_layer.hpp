#pragma once

#include <optional>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/tile_file.hpp"
#include "io/openfoam/foam_case.hpp"
#include "mesher/cells/cell_materials.hpp"
#include "mesher/finite_volume/extruded_mesh.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Returns the case of a tile of the plane: one layer of prisms with a DecayingFlow.
///
/// Cell i is face i of the tile; in a tile of cells without repetition it is the cell of site i.
/// The notes hold the kind of the faces, the period vectors, the site of each cell, the notes of
/// the sites (io/forms/site_notes.hpp) and the phases. The cells of each phase are the zone
/// phase_NAME.
///
/// Example usage:
///     const std::vector<EncodedFile> files = encode_foam(foam_case(tile, extruded_mesh(tile)),
///     "tile.foam");
///
/// @param layer      extruded_mesh(tile), which must outlive the case.
/// @param materials  of the sites of one period, for faces that have sites; null: none.
/// @throws InternalError if a coordinate is not finite.
FoamCase foam_case(const plane::Tile& tile, const FiniteVolumeMesh& layer,
                   const CellMaterials* materials = nullptr);

/// Reads the tile at the back of a case that is one cell thick, with the edge pairs of its cyclic
/// patches. Only files in constant/polyMesh are read, in any order within `files`.
///
/// Example usage:
///     std::vector<EncodedFile> files;
///     for (const std::string& path : foam_paths("tile.foam", FoamCells::kLayer)) {
///         files.push_back({path, read_whole_file(path)});
///     }
///     const TileFile file = decode_foam_layer(files, std::nullopt);
///
/// @param lattice  used if the boundary file lacks the comment `pcvt lattice`, because another
///                 program wrote it.
/// @throws BadFile  if a file is missing or is not in OpenFOAM's ASCII format.
/// @throws NotATile if the mesh violates the laws of extruded_mesh().
TileFile decode_foam_layer(const std::vector<EncodedFile>& files,
                           const std::optional<plane::Lattice>& lattice);

}  // namespace pcvt
