#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/cells/cell_materials.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Encodes a tile as Gmsh MSH 4.1 in ASCII with double precision: triangles, with six nodes for
/// order 2, and their periodicity.
///
/// Node v + 1 is vertex v, element f + 1 is face f; line elements have the numbers after them.
/// Entities: as msh_entities() finds them. The block of an entity lists the nodes that lie on it.
/// Physical groups: `cell_s` with the number s + 1, the surface of site s; then `seam_I_J`, the
/// curves that I a + J b takes to their partners, by rising offset; then the curves on walls by the
/// words of kWallSides; then `grain_boundary`, the curves between cells; then `phase_NAME`, the
/// surfaces of the cells with that phase, which are in two groups. $Periodic lists each curve and
/// point that is not a master, with slave = master + translation, which has a larger offset, so
/// that links never run in a circle; a box between four walls has none. $ElementData "cell_id"
/// holds element_cells() for triangles and -1 for lines; $NodeData "cell_id" holds the site of each
/// vertex of Delaunay triangles and -1 for midside nodes; $ElementData "orbit" holds the orbit of
/// the cell of each triangle and -1 for lines. $Comments hold the kind, the lattice, the phases,
/// the orbits, and the positions of the sites where the tile knows them.
///
/// Example usage:
///     for (const EncodedFile& file : encode_msh(tile, "tile.msh")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @param materials    of the cells; null: no phases. Orientations are not written.
/// @param site_orbits  of the sites of one period; empty: none.
/// @throws InvalidInput   if the tile has polygons.
/// @throws InternalError  if a coordinate is not finite.
std::vector<EncodedFile> encode_msh(const plane::Tile& tile, const std::string& path,
                                    const CellMaterials* materials = nullptr,
                                    std::span<const int> site_orbits = {});

}  // namespace pcvt
