#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/tiles/encoded_file.hpp"
#include "mesher/cells/cell_materials.hpp"
#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

/// Encodes a tile as VTK's unstructured grid in XML with ASCII arrays: Float64 points with z = 0;
/// faces as VTK_POLYGON (cells) or VTK_TRIANGLE (VTK_QUADRATIC_TRIANGLE for order 2).
///
///   PointData  `GlobalIds`, counted from 0; `PeriodicPointIds`, the id of the representative,
///   which
///              is the smallest id on the orbit; `PeriodicOffset` (i, j), with
///              position = position(representative) + i a + j b; for Delaunay triangles `CellId`,
///              the site of each vertex, and -1 for a midside node.
///   CellData   `CellId`, the site of each cell, and element_cells() for triangles; for runs with a
///              symmetry `Orbit`, that of the site: orbits are counted from 0 in the order of their
///              first sites; for runs with phases or inclusions `Phase`, that of the site, an
///              index into `PhaseNames`.
///   FieldData  `PeriodicLattice`, the vectors a and b; where the tile knows its sites, `Periods`,
///              the numbers of periods along both, `SitePositions`, and `ShortEdges`, the length
///              below which edges of cells were removed, in units of h; for elongated cells
///              `Metric`, ratio and degrees, for power cells `SiteWeights`
///              (io/tiles/site_notes.hpp); with phases `PhaseNames`, the codes of the
///              characters of all names, each name ended by 0, and `SitePhases`, that of each site.
///
/// The arrays are ASCII, because the shortest decimals that round-trip are exact, take no more room
/// than raw binary arrays (12.7 MB for the triangles of 1e5 sites, against 12.6 MB), and let a
/// reader name the line of a fault.
///
/// Example usage:
///     for (const EncodedFile& file : encode_vtu(tile, "tile.vtu")) {
///         output.stage(file.path, file.bytes);
///     }
///
/// @param site_orbits  of the sites of one period; empty: none.
/// @param materials    of the sites of one period; the phases are written.
/// @throws InternalError if a coordinate is not finite.
std::vector<EncodedFile> encode_vtu(const plane::Tile& tile, const std::string& path,
                                    std::span<const int> site_orbits = {},
                                    const CellMaterials& materials = {});

}  // namespace pcvt
