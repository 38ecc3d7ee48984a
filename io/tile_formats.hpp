#pragma once

#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/tile_file.hpp"
#include "mesher/tile/openmesh_tile.hpp"

namespace pcvt {

/// One row of the table of formats, in the order of `tile_formats()`.
struct TileFormat {
    /// With the dot: ".obj".
    std::string extension;
    std::string description;
    /// The paths that encode() will fill for `path`, the file itself first; of a folder those in
    /// it.
    std::vector<std::string> (*paths)(const std::string& path);
    /// Turns a tile, as a mesh and the same as plain arrays, into bytes: one entry for each of the
    /// paths.
    std::vector<EncodedFile> (*encode)(const OpenMeshTile& mesh, const Tile& flat,
                                       const std::string& path);
    /// Reads `files` (the file itself first, companions where there are any) back. A lattice given
    /// here stands in for one that the file lacks. nullptr where pcvt does not read the format.
    TileFile (*decode)(const std::vector<EncodedFile>& files,
                       const std::optional<Lattice>& lattice);
    /// encode() refuses tiles with polygons.
    bool triangles_only = false;
    /// Whether nodes in the middle of edges are written, where the tile has them.
    bool second_order = false;
    /// Whether `path` is a folder of files.
    bool is_folder = false;
    /// Pieces of cells are not for this format.
    bool whole_cells_only = false;
};

const std::vector<TileFormat>& tile_formats();

/// The bytes of a tile in a format.
std::vector<EncodedFile> encode_tile(const TileFormat& format, const OpenMeshTile& tile,
                                     const std::string& path);

/// The row for the extension of `path` (case does not matter), nullptr if there is none.
const TileFormat* find_tile_format(const std::string& path);

}  // namespace pcvt
