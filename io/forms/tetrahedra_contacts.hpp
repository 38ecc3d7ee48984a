#pragma once

#include <array>
#include <vector>

#include "io/forms/element_mesh.hpp"

namespace pcvt {

/// A side of a tetrahedron.
struct TetrahedronSide {
    /// By rising numbers.
    std::array<int, 3> points;
    /// 4 t + k: opposite to corner k of tetrahedron t.
    int place;

    int tetrahedron() const { return place / 4; }
    int apex() const { return place % 4; }
    friend auto operator<=>(const TetrahedronSide&, const TetrahedronSide&) = default;
};

/// Returns the four sides of each tetrahedron, in an order in which the two that have the same
/// points follow each other.
std::vector<TetrahedronSide> sorted_sides(const space::TetrahedralMesh& mesh);

/// A triangle on both of its tetrahedra.
struct SharedTriangle {
    std::array<int, 2> tetrahedra;
    /// The corner of each tetrahedron opposite to the triangle, from 0 to 3.
    std::array<int, 2> apexes;
    /// Takes the points of the first tetrahedron to those of the second; 0 inside of the tile.
    space::Offset offset = {};
    /// Whether the tetrahedra lie in different cells, or in different images of one cell.
    bool is_between_cells = false;

    bool is_on_seam() const { return offset != space::Offset{}; }
};

/// Where the cells of tetrahedra meet. A cell that consists of one part in the tile counts as
/// whole, so that it meets images of itself across the seam; another one is cut there. Laws, tested
/// by number:
///
///   (1) Each triangle of the torus is there once.
///   (2) All images of a node are in the same lists, and each list contains the next one.
///   (3) The nodes of triangles between cells are those at which two cells meet, or more.
struct TetrahedraContacts {
    std::vector<SharedTriangle> triangles = {};
    /// The nodes at which two, three and four cells meet, or more, each list rising. Empty without
    /// cells.
    std::array<std::vector<int>, 3> nodes = {};
};

/// Whether node k of a tetrahedron with four or ten nodes lies on the side opposite to a corner.
bool is_on_side(std::size_t k, int apex);

/// Example usage:
///     const TetrahedraContacts contacts = cell_contacts(mesh, element_mesh(mesh));
///     for (const int v : contacts.nodes[0]) set.push_back(v);
///
/// Cost: t log t for t tetrahedra.
///
/// @param elements  element_mesh() of the mesh.
TetrahedraContacts cell_contacts(const space::TetrahedralMesh& mesh, const ElementMesh& elements);

}  // namespace pcvt
