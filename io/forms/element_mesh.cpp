#include "io/forms/element_mesh.hpp"

#include <algorithm>
#include <numeric>

#include "io/forms/finite.hpp"
#include "io/forms/point_offsets.hpp"
#include "io/forms/triangle_elements.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/space/mesh/midside_nodes.hpp"

namespace pcvt {
namespace {

ElementKind kind_of(const plane::Tile& tile) {
    if (tile.kind == plane::MeshKind::kVoronoi) return ElementKind::kPolygon;
    return tile.order == 2 ? ElementKind::kTriangle6 : ElementKind::kTriangle3;
}

std::vector<int> counted(int n) {
    std::vector<int> numbers(static_cast<std::size_t>(n));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

/// The parts of a mesh in space but its elements.
ElementMesh nodes_in_space(const space::Lattice& lattice, const std::vector<space::Vec3>& points,
                           const std::vector<int>& orbit,
                           const std::vector<space::Offset>& offsets) {
    ElementMesh mesh{.dimension = 3};
    for (const space::Vec3& period : lattice.periods()) {
        mesh.periods.insert(mesh.periods.end(), period.begin(), period.end());
    }
    mesh.nodes.reserve(points.size());
    for (const space::Vec3& p : points) mesh.nodes.push_back({p.x(), p.y(), p.z()});
    mesh.orbit = orbit;
    mesh.offsets.reserve(3 * offsets.size());
    for (const auto& [i, j, k] : offsets) mesh.offsets.insert(mesh.offsets.end(), {i, j, k});
    return mesh;
}

/// Adds the nodes in the middle of edges to tetrahedra with four nodes.
void add_middles(const space::TetrahedralMesh& tetrahedra, ElementMesh& mesh) {
    const space::MidsideNodes middles = midside_nodes(tetrahedra);
    for (const space::Vec3& p : middles.points) mesh.nodes.push_back({p.x(), p.y(), p.z()});
    mesh.orbit.insert(mesh.orbit.end(), middles.orbit.begin(), middles.orbit.end());
    for (const auto& [i, j, k] : middles.offset) {
        mesh.offsets.insert(mesh.offsets.end(), {i, j, k});
    }
    if (!mesh.node_site.empty()) mesh.node_site.resize(mesh.nodes.size(), -1);
    mesh.elements = {.kind = ElementKind::kTetrahedron10};
    for (int t = 0; t < tetrahedra.n_tetrahedra(); ++t) {
        checkpoint_each(t);
        std::vector<int>& nodes = mesh.elements.nodes.corners;
        const std::array<int, 4>& corners = tetrahedra.tetrahedra[t];
        const std::array<int, 6>& of_edges = middles.of_tetrahedron[t];
        nodes.insert(nodes.end(), corners.begin(), corners.end());
        nodes.insert(nodes.end(), of_edges.begin(), of_edges.end());
        mesh.elements.nodes.close();
    }
}

}  // namespace

ElementMesh element_mesh(const plane::Tile& tile, const SolverNodes& nodes) {
    require_finite(tile);
    const plane::Vec2& a = tile.lattice.a();
    const plane::Vec2& b = tile.lattice.b();
    ElementMesh mesh{.dimension = 2, .periods = {a.x(), a.y(), b.x(), b.y()}};
    mesh.nodes.reserve(nodes.points.size());
    for (const plane::Vec2& p : nodes.points) mesh.nodes.push_back({p.x(), p.y(), 0});
    // A node without a pair represents its own orbit.
    mesh.orbit = counted(nodes.n_nodes());
    mesh.offsets.resize(2 * nodes.points.size());
    for (const auto& [v, w, offset] : nodes.pairs) {
        mesh.orbit[w] = v;
        mesh.offsets[2 * w] = offset.i;
        mesh.offsets[2 * w + 1] = offset.j;
    }
    mesh.elements.kind = kind_of(tile);
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        mesh.elements.nodes.add(element_nodes(tile, nodes, f));
    }
    if (!tile.vertex_site.empty()) {
        mesh.node_site = tile.vertex_site;
        mesh.node_site.resize(nodes.points.size(), -1);
    }
    mesh.element_site = element_cells(tile);
    return mesh;
}

ElementMesh element_mesh(const space::TetrahedralMesh& tetrahedra) {
    ElementMesh mesh = nodes_in_space(tetrahedra.lattice, tetrahedra.points,
                                      first_points(tetrahedra), tetrahedra.point_offset);
    mesh.elements.kind = ElementKind::kTetrahedron4;
    for (const std::array<int, 4>& corners : tetrahedra.tetrahedra)
        mesh.elements.nodes.add(corners);
    if (tetrahedra.cell.empty()) {
        mesh.node_site = tetrahedra.point_site;
    } else {
        mesh.element_site = tetrahedra.cell;
    }
    if (tetrahedra.order == 2) add_middles(tetrahedra, mesh);
    return mesh;
}

ElementMesh element_mesh(const space::PolyhedralMesh& polyhedra,
                         const space::PolyhedronList& cells) {
    ElementMesh mesh = nodes_in_space(polyhedra.lattice, polyhedra.points, polyhedra.point_orbit,
                                      polyhedra.point_offset);
    mesh.elements.kind = ElementKind::kPolyhedron;
    for (int s = 0; s < cells.n_cells(); ++s) {
        checkpoint_each(s);
        mesh.elements.nodes.add(cell_points(cells, s));
    }
    mesh.element_site =
        polyhedra.piece_cell.empty() ? counted(cells.n_cells()) : polyhedra.piece_cell;
    return mesh;
}

std::vector<int> cell_points(const space::PolyhedronList& cells, int cell) {
    const auto begin = cells.faces.corners.begin();
    std::vector<int> points(begin + cells.faces.begin[cells.cell_begin[cell]],
                            begin + cells.faces.begin[cells.cell_begin[cell + 1]]);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}  // namespace pcvt
