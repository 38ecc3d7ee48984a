#pragma once

#include <array>
#include <vector>

#include "io/forms/element_types.hpp"
#include "io/forms/solver_nodes.hpp"
#include "mesher/base/faces.hpp"
#include "mesher/plane/tile/tile.hpp"
#include "mesher/space/mesh/polyhedral_assembly.hpp"
#include "mesher/space/mesh/tetrahedral_mesh.hpp"

namespace pcvt {

/// Elements of one kind.
struct ElementList {
    ElementKind kind = ElementKind::kPoint;
    /// The nodes of each element, counted from 0.
    Faces nodes = {};

    const ElementType& type() const { return element_type(kind); }
    int size() const { return nodes.n_faces(); }
};

/// A tile of elements on nodes, in the plane or in space, as formats of solvers count them.
///
/// Example usage:
///     const ElementMesh mesh = element_mesh(tile, solver_nodes(tile));
///     for (int e = 0; e < mesh.elements.size(); ++e) write(mesh.elements.nodes[e]);
struct ElementMesh {
    /// 2 in the plane, 3 in space: the number of periods, of their coordinates, and of the numbers
    /// of an offset.
    int dimension;
    /// The coordinates of the first period, then those of the next one, length units.
    std::vector<double> periods = {};
    /// x, y and z, which is 0 in the plane, length units.
    std::vector<std::array<double, 3>> nodes = {};
    /// For each node the smallest number on its orbit, and the offset from that node: `dimension`
    /// numbers a node.
    std::vector<int> orbit = {};
    std::vector<int> offsets = {};
    /// The elements that fill the tile.
    ElementList elements = {};
    /// The site of each node, -1 for a node in the middle of an edge; empty where nodes have none.
    std::vector<SiteId> node_site = {};
    /// The site of the cell of each element; empty where elements have none.
    std::vector<SiteId> element_site = {};

    int n_nodes() const { return static_cast<int>(nodes.size()); }
};

/// Polygons or triangles. Triangles of order 2 have six nodes: the vertices of the tile come before
/// the nodes in the middle of edges. Delaunay triangles have sites of nodes and, as the cell of
/// each, that of element_cells().
/// @param nodes  solver_nodes() of the tile.
/// @throws InternalError if a coordinate is not finite.
ElementMesh element_mesh(const plane::Tile& tile, const SolverNodes& nodes);

/// Tetrahedra with the sites of their nodes or, inside of cells, with those of their cells. Those
/// of order 2 have ten nodes: the points of the tile come before the nodes in the middle of edges.
ElementMesh element_mesh(const space::TetrahedralMesh& mesh);

/// Polyhedra: the nodes of each are its points by rising number. Cell s belongs to site s.
/// @param cells  polyhedron_list() of the mesh.
ElementMesh element_mesh(const space::PolyhedralMesh& mesh, const space::PolyhedronList& cells);

/// Returns the points of a cell, by rising number.
std::vector<int> cell_points(const space::PolyhedronList& cells, int cell);

}  // namespace pcvt
