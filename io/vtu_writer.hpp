#pragma once

#include <string>
#include <vector>

#include "io/tile_formats.hpp"

namespace pcvt {

/// VTK's unstructured grid in XML, ASCII: Float64 points with z = 0, faces as VTK_POLYGON (cells)
/// or VTK_TRIANGLE
/// (VTK_QUADRATIC_TRIANGLE for order 2).
///
/// PointData: `GlobalIds`, counted from 0; `PeriodicPointIds`, the id of the representative, i.e.
/// the smallest on the orbit; `PeriodicOffset` (i, j), position = position(representative)
/// + i a + j b; of Delaunay triangles also `CellId`, the site there, -1 in
/// the middle of an edge. CellData: `CellId`, the site
/// of each cell, of triangles element_cells(). FieldData: `PeriodicLattice`, the vectors a and b.
///
/// The shortest decimals that round-trip are exact, are no longer than Base64 of the same arrays
/// plus a third, and name a fault by its line; compressed files gain nothing on them.
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_vtu(const FlatTile& tile, const std::string& path);
std::vector<EncodedFile> encode_vtu(const AnyTile& tile, const std::string& path);

}  // namespace pcvt
