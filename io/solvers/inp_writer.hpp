#pragma once

#include <string>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/forms/file_options.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Encodes the mesh part of an Abaqus or CalculiX input, which a job includes, with
/// options.materials also the sections of the cells (inp_sections()), and with options.job a job
/// that runs as it is (inp_elastic_job()). The mesh consists of triangles
/// CPE3, or CPS3 for plane stress (CPE6, CPS6 for order 2), or of one layer of wedges C3D6 or C3D15
/// above them, whose sets and equations are those of space (inp_wedges.hpp). Node v + 1 is vertex
/// v, element f + 1 is face f.
///
/// Element sets: `EALL`, and one set `CELL_s` for each cell with site s (element_cells()). A cell
/// that owns no Delaunay triangle has the triangles at its site, which their owners have as well.
/// Node sets: `NALL`; `GRAIN_BOUNDARY` and `TRIPLE_POINTS`, the nodes at which two or three cells
/// meet, or more (cell_contacts()); `seam_I_J`, the nodes that I a + J b takes to their partners;
/// `WALL_LEFT`, `WALL_RIGHT`, `WALL_BOTTOM` and `WALL_TOP`, the nodes on walls that no
/// equation ties, for boundary conditions;
/// `FIXED`, one representative, which holds the tile; `CONTROL_1` and `CONTROL_2`, two nodes
/// outside of the mesh whose displacements are the mean strain: node 1 carries e_xx and e_xy, node
/// 2 carries e_yy in its second component.
///
/// The surfaces `WALL_LEFT_SIDES` and so on consist of the sides of elements on a wall, for loads.
/// A box between four walls has neither FIXED, nor control nodes, nor equations.
///
/// Two equations tie every other node of an orbit to its representative r, with
/// T = position(node) - position(r):
///
///   u_x(node) = u_x(r) + T_x e_xx + T_y e_xy        u_y(node) = u_y(r) + T_x e_xy + T_y e_yy
///
/// Lines that begin with "** pcvt" hold the kind, the lattice, the sites of nodes and,
/// where the tile has them, the positions of the sites; and the materials (material_words.hpp).
/// Solvers read 20 characters of a number; longer coordinates are rounded, by at most half an ulp
/// of the largest coordinate.
///
/// Example usage:
///     for (const EncodedFile& file : encode_inp(tile, {}, "tile.inp")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @throws InvalidInput   if the tile has polygons, or is so small or large in its unit of length
///                        that 20 characters cannot hold its numbers.
/// @throws InternalError  if a coordinate is not finite.
std::vector<EncodedFile> encode_inp(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path);

}  // namespace pcvt
