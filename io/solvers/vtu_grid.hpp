#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/forms/element_mesh.hpp"
#include "io/forms/space_tile.hpp"
#include "mesher/cells/cell_materials.hpp"

namespace pcvt {

/// The comments by which readers recognise the files of pcvt.
inline constexpr std::string_view kTileVtuMark = "<!-- A periodic tile, written by pcvt -->";
inline constexpr std::string_view kPolyhedraVtuMark =
    "<!-- A periodic tile of polyhedra, written by pcvt -->";
inline constexpr std::string_view kTetrahedraVtuMark =
    "<!-- A periodic tile of tetrahedra, written by pcvt -->";

/// A named array of VTK.
struct VtuData {
    /// "Int32", "Int64", "UInt8" or "Float64".
    const char* type;
    std::string_view name;
    /// Strings become the codes of their characters, each string ended by 0: VTK's own String
    /// arrays hold the same numbers, but meshio reads no file with such an array.
    std::variant<std::vector<int>, std::vector<double>, std::vector<std::string>> values;
    /// The numbers of a tuple.
    int n_components = 1;
    /// The numbers of a line of text.
    int in_line = n_components;
};

/// VTK's unstructured grid, with all of its arrays.
///
///   PointData  `GlobalIds`, counted from 0 (in the plane); `PeriodicPointIds`, the id of the
///              representative, which is the smallest id on the orbit; `PeriodicOffset`, (i, j) or
///              (I, J, K), with position = position(representative) + i a + j b + k c; for Delaunay
///              triangles and tetrahedra `CellId`, the site of each point, and -1 for a midside
///              node.
///   CellData   `CellId`, the site of each cell, but for Delaunay tetrahedra; for runs with a
///   symmetry
///              `Orbit`, that of the site: orbits are counted from 0 in the order of their first
///              sites; for runs with phases or inclusions `Phase`, that of the site, an index into
///              `PhaseNames`; of polyhedra `Faces`, their number, `Volume` (length^3), `Site`, the
///              image of the site, and of power cells `Weight`, length^2; in space, of cells with
///              orientations, `Orientation`, the angles phi1, Phi, phi2 in degrees, and `IPFz`,
///              their colour in the inverse pole figure (io/colours/pole_colours.hpp).
///   FieldData  `PeriodicLattice`, the period vectors; where the tile has its sites, `Periods`,
///              the numbers of periods along both, and `SitePositions`; `ShortEdges`, the length
///              below which edges of cells were removed, in units of h; for elongated cells
///              `Metric`, ratio and degrees, in space the ratio and the axis, for power cells
///              `SiteWeights` (io/forms/site_notes.hpp); with phases `PhaseNames` and `SitePhases`,
///              that of each site; with holes `HoleNames` and `HoleEdges` (hole, v0, v1).
///
/// Example usage:
///     for (const EncodedFile& file : encode_vtu(vtu_grid(tile), "tile.vtu")) {
///         output.stage(file.path, file.bytes);
///     }
struct VtuGrid {
    std::string_view mark;
    /// x, y and z, length units.
    std::vector<std::array<double, 3>> points;
    ElementList cells;
    /// For each polyhedron, the number of its faces; for each face the number of its points, and
    /// these, counter-clockwise seen from outside.
    Faces polyhedra = {};
    std::vector<VtuData> field_data = {};
    std::vector<VtuData> point_data = {};
    std::vector<VtuData> cell_data = {};
};

/// Polygons, or triangles with three or six nodes.
/// @param materials    of the sites of one period; null: no phases. Orientations are not written.
/// @param site_orbits  of the sites of one period; empty: none.
/// @throws InternalError if a coordinate is not finite.
VtuGrid vtu_grid(const plane::Tile& tile, const CellMaterials* materials = nullptr,
                 std::span<const int> site_orbits = {});

VtuGrid vtu_grid(const SpaceTile& tile);

/// Tetrahedra with four or ten nodes, with the volumes of cells that they fill as the field data
/// `CellVolumes`, whose fourth point lies on the side from which the others turn counter-clockwise.
/// @param materials  of the cells that they fill; null: none.
VtuGrid vtu_grid(const space::TetrahedralMesh& mesh, const CellMaterials* materials = nullptr);

}  // namespace pcvt
