#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/space/space_tile.hpp"
#include "io/tiles/encoded_file.hpp"
#include "mesher/space/mesh/polyhedral_assembly.hpp"

namespace pcvt {

/// The comment by which the reader knows a file of encode_space_vtu().
inline constexpr std::string_view kSpaceVtuMark =
    "<!-- A periodic tile of polyhedra, written by pcvt -->";

/// Encodes a tile of polyhedra as a VTU in ASCII, for ParaView and VTK: VTK_POLYHEDRON cells whose
/// faces run counter-clockwise seen from outside.
///
///   - Cells: CellId (the site), Volume (length^3), Faces (their number), Site (the image of the
///     site in the cell).
///   - Points: PeriodicPointIds (the smallest number on the orbit), PeriodicOffset (I, J, K), the
///     translation from that point.
///   - Grid: PeriodicLattice, the three period vectors.
///
/// Example usage:
///     for (const EncodedFile& file : encode_space_vtu(tile, "tile.vtu")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_space_vtu(const SpaceTile& tile, const std::string& path);

/// Returns the points of a cell, by rising number.
std::vector<int> cell_points(const space::PolyhedronList& cells, int cell);

}  // namespace pcvt
