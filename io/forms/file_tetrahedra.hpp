#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "io/forms/element_mesh.hpp"
#include "mesher/cells/cell_materials.hpp"

namespace pcvt {

/// The tetrahedra of a file, with four or ten nodes each.
///
/// Example usage:
///     FileTetrahedra found{.name = path, .index_base = 1};
///     found.elements = {ElementKind::kTetrahedron10, nodes};
///     place_tetrahedra(found, mesh);
struct FileTetrahedra {
    /// The name of the file in messages, and its number of the first node.
    std::string name = {};
    int index_base = 0;
    /// Nodes counted from 0, in the order of ElementType.
    ElementList elements = {};
    /// The line of each element.
    std::vector<int> lines = {};
};

/// Gives a mesh the tetrahedra of a file. Where these have ten nodes, the nodes in the middle of
/// edges go from its points and their sites, once they are proved to come behind all corners, to
/// lie in the middle of their edges, within 4 ulps of the largest coordinate, and to be one for
/// each edge; the order of the mesh is then 2.
/// @pre each node is a point of the mesh, which has a site for each point, or none.
/// @throws BadFile  with the line.
void place_tetrahedra(const FileTetrahedra& found, space::TetrahedralMesh& mesh);

/// A tile of tetrahedra in a file, and the materials of its cells.
struct TetrahedralTile {
    space::TetrahedralMesh mesh;
    CellMaterials materials = {};
};

/// A node of a file by its number, which counts from 1.
struct NumberedPoint {
    int number;
    int line;
    /// Length units.
    std::array<double, 3> position;
};

/// Returns the positions by rising numbers.
/// @param name  of the file, for messages.
/// @throws BadFile  unless the numbers are 1 ... n, each once.
std::vector<space::Vec3> points_by_number(const std::string& name,
                                          const std::vector<NumberedPoint>& nodes);

/// Returns whether a file of text holds tetrahedra of pcvt: its comments state that kind.
bool states_tetrahedra(std::string_view text);

/// Requires that the tetrahedra inside of cells come cell by cell, without a gap.
/// @throws BadFile  naming the file.
void require_sorted_cells(const std::string& name, const space::TetrahedralMesh& mesh);

}  // namespace pcvt
