#pragma once

#include "io/tiles/encoded_file.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// A picture of a tile. Cells are filled by their number of sides and carry a dot at their
/// centroid; triangles are pale, with a mark on each site whose valence is not six. The seam is
/// drawn thick, in one hue for each offset up to its sign, the fundamental domain dashed; a legend
/// names and counts.
///
/// Widths follow the size of the cells, so pictures of 1 and of 100,000 cells look alike. The
/// domain is the parallelogram of the period vectors, or of the reduced ones where those are much
/// shorter.
std::vector<EncodedFile> encode_svg(const Tile& tile, const std::string& path);

/// The same picture with cells filled by their size, sqrt(area of the cell) / h on a logarithmic
/// scale, and without dots; triangles as above.
std::vector<EncodedFile> encode_graded_svg(const Tile& tile, const std::string& path);

}  // namespace pcvt
