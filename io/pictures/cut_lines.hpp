#pragma once

#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

struct CutLine {
    plane::Vec2 from;
    plane::Vec2 to;
};

/// The edges of a tile as a cutter needs them, with the lower left corner of all at 0.
struct CutLines {
    /// The edges inside the tile and the edges of its boundary. Each edge is in one of the lists
    /// once.
    std::vector<CutLine> inner;
    std::vector<CutLine> seam;
    plane::Vec2 size;
};

/// Returns the edges of a tile.
/// @param width  of all lines together, in millimetres, of which lengths are then multiples of
/// 1e-6;
///               0: lengths as in the tile.
///
/// Example usage:
///   const CutLines lines = cut_lines(tile, 300);
///   for (const CutLine& line : lines.inner) cut(line.from, line.to);
CutLines cut_lines(const plane::Tile& tile, double width);

/// The layers of the two lists, in every format.
inline constexpr const char* kInnerLayer = "CUT";
inline constexpr const char* kSeamLayer = "SEAM";

}  // namespace pcvt
