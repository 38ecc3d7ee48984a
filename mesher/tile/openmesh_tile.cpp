#include "mesher/tile/openmesh_tile.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::Vec2i;
using OpenMesh::Vec3d;
using OpenMesh::VertexHandle;

/// One vertex of a tile: an orbit and where it stands.
struct Placed {
    int orbit;
    Offset offset;
    friend auto operator<=>(const Placed&, const Placed&) = default;
};

/// The vertices of the placed faces, numbered in the order in which the faces' corners meet them.
struct PlacedVertices {
    std::vector<Placed> vertices;
    std::vector<int> of_corner;
};

PlacedVertices place_vertices(const PeriodicMesh& periodic, const std::vector<Offset>& placement) {
    std::vector<Placed> corners;
    corners.reserve(periodic.corner_vertex.size());
    for (int f = 0; f < periodic.n_faces(); ++f) {
        for (int c = periodic.face_begin[f]; c < periodic.face_begin[f + 1]; ++c) {
            corners.push_back(
                {periodic.corner_vertex[c], placement[f] + periodic.corner_offset[c]});
        }
    }
    std::vector<int> order(corners.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int c, int d) { return std::tie(corners[c], c) < std::tie(corners[d], d); });
    // The first corner at each vertex, for every corner; then numbers by rising first corner.
    std::vector<int> first(corners.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && corners[order[k]] == corners[order[k - 1]];
        first[order[k]] = same ? first[order[k - 1]] : order[k];
    }
    PlacedVertices placed{{}, std::vector<int>(corners.size())};
    for (std::size_t c = 0; c < corners.size(); ++c) {
        if (first[c] == static_cast<int>(c)) {
            placed.of_corner[c] = static_cast<int>(placed.vertices.size());
            placed.vertices.push_back(corners[c]);
        } else {
            placed.of_corner[c] = placed.of_corner[first[c]];
        }
    }
    return placed;
}

Vec2i to_vec2i(Offset o) { return {o.i, o.j}; }
Offset to_offset(const Vec2i& v) { return {v[0], v[1]}; }

template <class Mesh>
void add_vertices(OpenMeshTileOf<Mesh>& tile, const PeriodicMesh& periodic,
                  const PlacedVertices& placed) {
    Mesh& mesh = tile.mesh;
    const OpenMeshProperties& id = tile.identification;
    std::vector<int> representative(periodic.vertices.size(), -1);
    for (const Placed& vertex : placed.vertices) {
        const Vec2 p = periodic.vertices[vertex.orbit] + tile.lattice.translation(vertex.offset);
        const VertexHandle v = mesh.add_vertex(Vec3d(p.x(), p.y(), 0));
        int& first = representative[vertex.orbit];
        if (first < 0) first = v.idx();
        mesh.property(id.orbit, v) = first;
        mesh.property(id.orbit_offset, v) = to_vec2i(vertex.offset - placed.vertices[first].offset);
        const bool is_site = periodic.kind == MeshKind::kDelaunay;
        mesh.property(id.vertex_site, v) = is_site ? periodic.site[vertex.orbit] : -1;
    }
}

/// Adds the faces and returns, for each corner, the halfedge that leaves it along its face.
template <class Mesh>
std::vector<HalfedgeHandle> add_faces(OpenMeshTileOf<Mesh>& tile, const PeriodicMesh& periodic,
                                      const PlacedVertices& placed) {
    Mesh& mesh = tile.mesh;
    std::vector<HalfedgeHandle> halfedge(periodic.corner_vertex.size());
    std::vector<VertexHandle> corners;
    for (int f = 0; f < periodic.n_faces(); ++f) {
        corners.clear();
        const int begin = periodic.face_begin[f];
        const int end = periodic.face_begin[f + 1];
        for (int c = begin; c < end; ++c) corners.emplace_back(placed.of_corner[c]);
        const FaceHandle face = mesh.add_face(corners);
        if (!face.is_valid()) throw InternalError("the faces of the tile do not form a disc");
        HalfedgeHandle h = mesh.halfedge_handle(face);
        while (mesh.from_vertex_handle(h) != corners.front()) h = mesh.next_halfedge_handle(h);
        for (int c = begin; c < end; ++c) {
            halfedge[c] = h;
            h = mesh.next_halfedge_handle(h);
        }
    }
    return halfedge;
}

template <class Mesh>
void note_face_sites(OpenMeshTileOf<Mesh>& tile, const PeriodicMesh& periodic,
                     const std::vector<Offset>& placement) {
    const OpenMeshProperties& id = tile.identification;
    const bool owned = faces_have_sites(periodic.kind);
    for (const auto face : tile.mesh.faces()) {
        const int f = face.idx();
        Vec2 p(0, 0);
        if (!periodic.site_points.empty()) {
            p = periodic.site_points[f] + tile.lattice.translation(placement[f]);
        }
        tile.mesh.property(id.face_site, face) = owned ? periodic.site[f] : -1;
        tile.mesh.property(id.site_point, face) = Vec3d(p.x(), p.y(), 0);
        tile.mesh.property(id.whole_sides, face) =
            periodic.whole_sides.empty() ? 0 : periodic.whole_sides[f];
    }
}

template <class Mesh>
void match_boundary(OpenMeshTileOf<Mesh>& tile, const PeriodicMesh& periodic,
                    const std::vector<HalfedgeHandle>& halfedge, const PlacedVertices& placed) {
    Mesh& mesh = tile.mesh;
    const OpenMeshProperties& id = tile.identification;
    for (const auto h : mesh.halfedges()) {
        mesh.property(id.partner, h) = -1;
        mesh.property(id.partner_offset, h) = Vec2i(0, 0);
    }
    for (std::size_t c = 0; c < halfedge.size(); ++c) {
        const HalfedgeHandle boundary = mesh.opposite_halfedge_handle(halfedge[c]);
        if (!mesh.is_boundary(boundary)) continue;
        const HalfedgeHandle across = halfedge[periodic.opposite[c]];
        // `boundary` starts where halfedge[c] ends, on the orbit that `across` leaves.
        const int from = mesh.from_vertex_handle(boundary).idx();
        const int partner_to = mesh.from_vertex_handle(across).idx();
        mesh.property(id.partner, boundary) = mesh.opposite_halfedge_handle(across).idx();
        mesh.property(id.partner_offset, boundary) =
            to_vec2i(placed.vertices[partner_to].offset - placed.vertices[from].offset);
    }
}

template <class Mesh>
OpenMeshTile assemble(const PeriodicMesh& periodic, const std::vector<Offset>& placement) {
    // Built in place: OpenMesh's meshes copy when they are moved.
    OpenMeshTile any(std::in_place_type<OpenMeshTileOf<Mesh>>, periodic.lattice, periodic.kind);
    auto& tile = std::get<OpenMeshTileOf<Mesh>>(any);
    const PlacedVertices placed = place_vertices(periodic, placement);
    tile.mesh.reserve(placed.vertices.size(), periodic.corner_vertex.size(), placement.size());
    add_vertices(tile, periodic, placed);
    const auto halfedge = add_faces(tile, periodic, placed);
    note_face_sites(tile, periodic, placement);
    match_boundary(tile, periodic, halfedge, placed);
    return any;
}

template <class Mesh>
void flatten_seam(const OpenMeshTileOf<Mesh>& tile, Tile& flat) {
    const Mesh& mesh = tile.mesh;
    const OpenMeshProperties& id = tile.identification;
    for (const auto v : mesh.vertices()) {
        const int orbit = mesh.property(id.orbit, v);
        if (orbit == v.idx()) continue;
        flat.vertex_pairs.push_back({orbit, v.idx(), to_offset(mesh.property(id.orbit_offset, v))});
    }
    for (const auto h : mesh.halfedges()) {
        const Offset offset = to_offset(mesh.property(id.partner_offset, h));
        // Of a pair the side whose translation is positive: the other one has the negative.
        if (mesh.property(id.partner, h) < 0 || offset < Offset{}) continue;
        const HalfedgeHandle partner(mesh.property(id.partner, h));
        flat.edge_pairs.push_back({mesh.to_vertex_handle(h).idx(), mesh.from_vertex_handle(h).idx(),
                                   mesh.from_vertex_handle(partner).idx(),
                                   mesh.to_vertex_handle(partner).idx(), offset});
    }
}

template <class Mesh>
Tile flatten_mesh(const OpenMeshTileOf<Mesh>& tile) {
    const Mesh& mesh = tile.mesh;
    const OpenMeshProperties& id = tile.identification;
    Tile flat{tile.lattice, tile.kind, {}, {0}, {}, {}, {}, {}, {}};
    flat.order = tile.order;
    for (const auto v : mesh.vertices()) {
        flat.points.emplace_back(mesh.point(v)[0], mesh.point(v)[1]);
        if (tile.kind == MeshKind::kDelaunay)
            flat.vertex_site.push_back(mesh.property(id.vertex_site, v));
    }
    for (const auto f : mesh.faces()) {
        for (const auto v : mesh.fv_ccw_range(f)) flat.corners.push_back(v.idx());
        flat.face_begin.push_back(static_cast<int>(flat.corners.size()));
        if (tile.kind == MeshKind::kDelaunay) continue;
        flat.face_site.push_back(mesh.property(id.face_site, f));
        const int whole_sides = mesh.property(id.whole_sides, f);
        if (whole_sides > 0) flat.whole_sides.push_back(whole_sides);
        if (tile.kind != MeshKind::kVoronoi) continue;
        const Vec3d& site = mesh.property(id.site_point, f);
        flat.site_points.emplace_back(site[0], site[1]);
    }
    flatten_seam(tile, flat);
    return flat;
}

}  // namespace

OpenMeshTile make_tile(const PeriodicMesh& periodic, const std::vector<Offset>& placement) {
    if (periodic.kind == MeshKind::kVoronoi) return assemble<CellMesh>(periodic, placement);
    return assemble<TriangleMesh>(periodic, placement);
}

Tile flatten(const OpenMeshTile& tile) {
    return std::visit([](const auto& any) { return flatten_mesh(any); }, tile);
}

}  // namespace pcvt
