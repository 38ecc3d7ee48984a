#pragma once

#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/tile/tile.hpp"

namespace pcvt {

/// VTK's unstructured grid in XML, ASCII: Float64 points with z = 0, faces as VTK_POLYGON (cells)
/// or VTK_TRIANGLE
/// (VTK_QUADRATIC_TRIANGLE for order 2).
///
/// PointData: `GlobalIds`, counted from 0; `PeriodicPointIds`, the id of the representative, i.e.
/// the smallest on the orbit; `PeriodicOffset` (i, j), position = position(representative)
/// + i a + j b; of Delaunay triangles also `CellId`, the site there, -1 in the middle of an edge.
/// CellData: `CellId`, the site of each cell, of triangles element_cells(). FieldData:
/// `PeriodicLattice`, the vectors a and b.
///
/// ASCII, because the shortest decimals that round-trip are exact, take no more room than the same
/// arrays in raw binary (12.7 MB for the triangles of 1e5 sites, against 12.6), and let a reader
/// name a fault by its line.
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_vtu(const Tile& tile, const std::string& path);

}  // namespace pcvt
