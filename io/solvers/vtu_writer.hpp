#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/solvers/vtu_grid.hpp"

namespace pcvt {

/// Encodes a grid as VTK's unstructured grid in XML with ASCII arrays.
///
/// The arrays are ASCII, because the shortest decimals that round-trip are exact, take no more room
/// than raw binary arrays (12.7 MB for the triangles of 1e5 sites, against 12.6 MB), and let a
/// reader name the line of a fault.
///
/// Example usage:
///     for (const EncodedFile& file : encode_vtu(vtu_grid(tile), "tile.vtu")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InternalError if a number is not finite.
std::vector<EncodedFile> encode_vtu(const VtuGrid& grid, const std::string& path);

}  // namespace pcvt
