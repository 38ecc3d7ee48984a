#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/space/mesh/tetrahedral_mesh.hpp"

namespace pcvt {

/// The comment by which the reader knows a file of encode_tetrahedra_vtu().
inline constexpr std::string_view kTetrahedraVtuMark =
    "<!-- A periodic tile of tetrahedra, written by pcvt -->";

/// Encodes a tile of Delaunay tetrahedra as a VTU in ASCII, for ParaView, VTK and meshio:
/// VTK_TETRA cells whose fourth point lies on the side from which the others turn
/// counter-clockwise.
///
///   - Points: CellId (the site), PeriodicPointIds (the first point of that site), PeriodicOffset
///     (I, J, K), by which a point is that point plus I a + J b + K c.
///   - Field data: PeriodicLattice, the three period vectors.
///
/// Example usage:
///     for (const EncodedFile& file : encode_tetrahedra_vtu(mesh, "tile.vtu")) {
///         output.stage(file.path, file.bytes);
///     }
std::vector<EncodedFile> encode_tetrahedra_vtu(const space::TetrahedralMesh& mesh,
                                               const std::string& path);

}  // namespace pcvt
