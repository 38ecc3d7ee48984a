#pragma once

#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// The mesh part of an Abaqus or CalculiX input, to be included by a job: triangles CPE3
/// (CPE6 for order 2), node v + 1 is vertex v, element f + 1 is face f.
///
/// Sets: elements `EALL` and `CELL_s`, one a cell with the site s (element_cells()); nodes `NALL`;
/// `SEAM_I_J`, the boundary nodes that I a + J b takes to others; `FIXED`, one representative, to
/// hold the tile; `CONTROL_1` and `CONTROL_2`, two nodes outside of the mesh whose displacements
/// are the mean strain: node 1 carries e_xx and e_xy, node 2 e_yy as its second.
///
/// Every node that is not the representative r of its orbit is tied to r by two equations, where
/// T = position(node) - position(r):
///
///   u_x(node) = u_x(r) + T_x e_xx + T_y e_xy        u_y(node) = u_y(r) + T_x e_xy + T_y e_yy
///
/// Lines that begin with "** pcvt" hold the kind, the lattice and the sites of nodes. Solvers read
/// 20 characters of a number: coordinates that need more are rounded, by half an ulp of the largest
/// coordinate at most.
/// @throws InvalidInput   the tile has polygons, or is so small or large in its unit of length that
///                        20 characters do not hold its numbers.
/// @throws InternalError  a coordinate is not finite.
std::vector<EncodedFile> encode_inp(const Tile& tile, const std::string& path);

}  // namespace pcvt
