#pragma once

#include <optional>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "io/tiles/tile_file.hpp"

namespace pcvt {

/// Reads the mesh of an Abaqus or CalculiX input: *NODE in the plane z = 0, *ELEMENT of triangles
/// (CPE3, CPS3, and CPE6, CPS6 with straight sides), the sets `CELL_s`, and our comments; other
/// cards are passed over.
///
/// Vertex pairs come from *EQUATION, in a file with the node sets CONTROL_1 and CONTROL_2: each
/// tied node has one equation of each direction of the form that encode_inp() writes, both with the
/// same translation, and its master is not tied itself. Edge pairs have no place there.
/// @throws BadFile with the line.
TileFile decode_inp(const std::vector<EncodedFile>& files, const std::optional<Lattice>& lattice);

}  // namespace pcvt
