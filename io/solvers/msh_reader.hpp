#pragma once

#include <optional>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {

/// Reads an ASCII MSH 4.1 as pcvt or Gmsh writes it: one entry a line; nodes in the plane z = 0,
/// triangles of three nodes, or of six with straight sides, and lines and points, which are passed
/// over.
///
/// Vertex pairs come from $Periodic, whose affine maps must be translations; edge pairs from the
/// lines of curves that it links, in a file whose $Comments are ours. Sites come from $NodeData or
/// $ElementData "cell_id", the lattice from $Comments; other sections are passed over.
/// @throws BadFile with the line.
TileFile decode_msh(const std::vector<EncodedFile>& files, const std::optional<Lattice>& lattice);

}  // namespace pcvt
