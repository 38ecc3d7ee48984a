#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/colours/colouring.hpp"
#include "io/forms/space_tile.hpp"
#include "mesher/plane/geometry/lattice.hpp"

namespace pcvt {

/// A face of a tile as a picture shows it: its corners in the plane of the picture, length units,
/// y upwards, and its shaded colour.
struct ShownFace {
    std::vector<plane::Vec2> corners;
    Colour colour;
};

/// Returns the faces of the boundary of a tile that face the viewer, from back to front, in
/// parallel projection. A line meets Voronoi cells in the order of their sites along it, so that
/// painting the cells in this order hides every hidden surface. Each cell has the colour of its
/// class, darker where a face turns off the light.
/// @param colours  one entry a cell.
/// @pre the tile has the sites of its cells.
std::vector<ShownFace> shown_faces(const SpaceTile& tile, const TileColours& colours);

/// The colours of the cells of a tile.
TileColours cell_colours(const SpaceTile& tile, Colouring colouring);

/// Encodes a picture of a tile, with a legend in SVG.
///
/// Example usage:
///     for (const EncodedFile& file : encode_space_svg(tile, Colouring::kFaces, "tile.svg")) {
///         output.stage(file.path, file.bytes);
///     }
std::vector<EncodedFile> encode_space_svg(const SpaceTile& tile, Colouring colouring,
                                          const std::string& path);
std::vector<EncodedFile> encode_space_png(const SpaceTile& tile, Colouring colouring,
                                          const std::string& path);

}  // namespace pcvt
