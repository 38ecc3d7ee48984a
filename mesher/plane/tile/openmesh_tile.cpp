#include "mesher/plane/tile/openmesh_tile.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/tile/site_positions.hpp"
#include "mesher/plane/tile/tile_edges.hpp"
#include "mesher/plane/tile/tile_holes.hpp"

namespace pcvt::plane {
namespace {

using OpenMesh::HalfedgeHandle;
using OpenMesh::Vec2i;
using OpenMesh::Vec3d;
using OpenMesh::VertexHandle;
using std::to_string;

Vec2i to_vec2i(Offset o) { return {o.i, o.j}; }
Offset to_offset(const Vec2i& v) { return {v[0], v[1]}; }

[[noreturn]] void refuse_arrays(const std::string& complaint) {
    throw InvalidInput("no OpenMesh structure holds the tile: " + complaint);
}

[[noreturn]] void refuse_mesh(const std::string& complaint) {
    throw InvalidInput("the OpenMesh structure is not a tile: " + complaint);
}

/// Turns arrays into a mesh.
template <class Mesh>
class MeshBuilder {
   public:
    MeshBuilder(const Tile& arrays, OpenMeshTileOf<Mesh>& built)
        : arrays_(arrays), mesh_(built.mesh), id_(built.identification) {
        built.order = arrays.order;
        note_sites();
    }

    void build() {
        mesh_.reserve(arrays_.points.size(), arrays_.faces.corners.size(),
                      static_cast<std::size_t>(arrays_.n_faces()));
        add_vertices();
        add_faces();
        note_orbits();
        match_boundary();
    }

   private:
    void note_sites() {
        mesh_.property(id_.site_weights) = arrays_.site_weights;
        const Metric& metric = arrays_.metric;
        mesh_.property(id_.metric).clear();
        if (!metric.is_round()) mesh_.property(id_.metric) = {metric.ratio(), metric.degrees()};
        const std::array<double, 2> walls = walls_as_numbers(arrays_.walls);
        const bool has_walls = arrays_.walls != Walls::kNone;
        mesh_.property(id_.walls).assign(walls.begin(), has_walls ? walls.end() : walls.begin());
        mesh_.property(id_.holes) = holes_as_numbers(arrays_);
        const std::vector<Vec2> positions = site_positions(arrays_);
        std::vector<double>& sites = mesh_.property(id_.sites);
        sites.clear();
        if (positions.empty()) return;
        sites = {double(arrays_.columns), double(arrays_.rows), arrays_.short_edges, 0};
        for (const Vec2& p : positions) sites.insert(sites.end(), {p.x(), p.y()});
    }

    void add_vertices() {
        for (int v = 0; v < arrays_.n_vertices(); ++v) {
            checkpoint_each(v);
            const Vec2& p = arrays_.points[v];
            const VertexHandle vertex = mesh_.add_vertex(Vec3d(p.x(), p.y(), 0));
            mesh_.property(id_.orbit, vertex) = v;
            mesh_.property(id_.orbit_offset, vertex) = Vec2i(0, 0);
            mesh_.property(id_.vertex_site, vertex) =
                arrays_.vertex_site.empty() ? -1 : arrays_.vertex_site[v];
        }
    }

    void add_faces() {
        std::vector<VertexHandle> corners;
        for (int f = 0; f < arrays_.n_faces(); ++f) {
            checkpoint_each(f);
            corners.clear();
            for (const int v : arrays_.faces[f]) {
                require_vertex(v);
                corners.emplace_back(v);
            }
            // OpenMesh would cut larger faces of a triangle mesh into triangles.
            if (corners.size() < 3 || (corners.size() > 3 && !Mesh::is_polymesh())) {
                refuse_arrays("face " + to_string(f) + " has " + to_string(corners.size()) +
                              " corners");
            }
            const auto face = mesh_.add_face(corners);
            if (!face.is_valid()) {
                refuse_arrays("face " + to_string(f) + " and those before it form no surface");
            }
            mesh_.property(id_.site_point, face) = {};
            if (!arrays_.site_points.empty()) {
                const Vec2& p = arrays_.site_points[f];
                mesh_.property(id_.site_point, face) = {p.x(), p.y()};
            }
            mesh_.property(id_.face_site, face) =
                arrays_.face_site.empty() ? -1 : arrays_.face_site[f];
            mesh_.property(id_.whole_sides, face) =
                arrays_.whole_sides.empty() ? 0 : arrays_.whole_sides[f];
        }
    }

    void note_orbits() {
        for (const VertexPair& pair : arrays_.vertex_pairs) {
            require_vertex(pair.v);
            require_vertex(pair.w);
            mesh_.property(id_.orbit, VertexHandle(pair.w)) = pair.v;
            mesh_.property(id_.orbit_offset, VertexHandle(pair.w)) = to_vec2i(pair.offset);
        }
    }

    void match_boundary() {
        for (const auto h : mesh_.halfedges()) {
            mesh_.property(id_.partner, h) = -1;
            mesh_.property(id_.partner_offset, h) = Vec2i(0, 0);
        }
        for (const EdgePair& pair : arrays_.edge_pairs) {
            const HalfedgeHandle here = free_side(pair.v1, pair.v0);
            const HalfedgeHandle there = free_side(pair.w0, pair.w1);
            link(here, there, pair.offset);
            link(there, here, -pair.offset);
        }
        std::set<int> on_walls;
        for (const WallEdge& e : arrays_.wall_edges) on_walls.insert(free_side(e.v1, e.v0).idx());
        for (const auto h : mesh_.halfedges()) {
            const bool is_paired = mesh_.property(id_.partner, h) >= 0;
            if (!mesh_.is_boundary(h) || is_paired || on_walls.contains(h.idx())) continue;
            refuse_arrays("the pairs lack the boundary edge " + edge(h));
        }
    }

    void link(HalfedgeHandle from, HalfedgeHandle to, Offset offset) {
        mesh_.property(id_.partner, from) = to.idx();
        mesh_.property(id_.partner_offset, from) = to_vec2i(offset);
    }

    /// The halfedge from v to w, on the boundary and in no pair yet.
    HalfedgeHandle free_side(int v, int w) const {
        require_vertex(v);
        require_vertex(w);
        const HalfedgeHandle h = mesh_.find_halfedge(VertexHandle(v), VertexHandle(w));
        if (!h.is_valid() || !mesh_.is_boundary(h)) {
            refuse_arrays("a pair names the edge from " + to_string(w) + " to " + to_string(v) +
                          ", which is not on the boundary");
        }
        if (mesh_.property(id_.partner, h) >= 0)
            refuse_arrays("two pairs name the edge " + edge(h));
        return h;
    }

    /// The edge of a boundary halfedge, as its face sees it.
    std::string edge(HalfedgeHandle h) const {
        return "from " + to_string(mesh_.to_vertex_handle(h).idx()) + " to " +
               to_string(mesh_.from_vertex_handle(h).idx());
    }

    void require_vertex(int v) const {
        if (v >= 0 && v < arrays_.n_vertices()) return;
        refuse_arrays("vertex " + to_string(v) + " does not exist");
    }

    const Tile& arrays_;
    Mesh& mesh_;
    const OpenMeshProperties& id_;
};

template <class Mesh>
OpenMeshTile build_mesh(const Tile& arrays) {
    // Built in place: OpenMesh's meshes copy when they are moved.
    OpenMeshTile any(std::in_place_type<OpenMeshTileOf<Mesh>>, arrays.lattice, arrays.kind);
    MeshBuilder<Mesh>(arrays, std::get<OpenMeshTileOf<Mesh>>(any)).build();
    return any;
}

/// Turns a mesh into arrays.
template <class Mesh>
class ArrayBuilder {
   public:
    explicit ArrayBuilder(const OpenMeshTileOf<Mesh>& source)
        : mesh_(source.mesh),
          id_(source.identification),
          arrays_{.lattice = source.lattice, .kind = source.kind, .order = source.order} {}

    Tile build() {
        require_plain_mesh();
        take_vertices();
        take_faces();
        take_orbits();
        take_partners();
        take_sites();
        return std::move(arrays_);
    }

   private:
    /// Handles are indices only where nothing is deleted.
    void require_plain_mesh() const {
        if (mesh_.n_faces() == 0) refuse_mesh("it has no face");
        const auto deleted = [&](const auto& handles) {
            for (const auto handle : handles) {
                if (mesh_.status(handle).deleted()) return true;
            }
            return false;
        };
        if ((mesh_.has_face_status() && deleted(mesh_.all_faces())) ||
            (mesh_.has_vertex_status() && deleted(mesh_.all_vertices())) ||
            (mesh_.has_edge_status() && deleted(mesh_.all_edges()))) {
            refuse_mesh("elements are deleted; call garbage_collection()");
        }
    }

    void take_vertices() {
        arrays_.points.reserve(mesh_.n_vertices());
        for (const auto v : mesh_.vertices()) {
            arrays_.points.emplace_back(mesh_.point(v)[0], mesh_.point(v)[1]);
        }
        if (arrays_.kind != MeshKind::kDelaunay) return;
        for (const auto v : mesh_.vertices()) {
            const int site = mesh_.property(id_.vertex_site, v);
            if (site >= 0) arrays_.vertex_site.push_back(site);
        }
        require_all_or_none(arrays_.vertex_site.size(), mesh_.n_vertices(), "vertices have sites");
    }

    void take_faces() {
        for (const auto f : mesh_.faces()) {
            for (const auto v : mesh_.fv_ccw_range(f)) arrays_.faces.corners.push_back(v.idx());
            arrays_.faces.close();
            if (!faces_have_sites(arrays_.kind)) continue;
            const int site = mesh_.property(id_.face_site, f);
            if (site >= 0) arrays_.face_site.push_back(site);
            const int whole_sides = mesh_.property(id_.whole_sides, f);
            if (whole_sides > 0) arrays_.whole_sides.push_back(whole_sides);
            const SitePoint& point = mesh_.property(id_.site_point, f);
            if (arrays_.kind == MeshKind::kVoronoi && point.is_known()) {
                arrays_.site_points.emplace_back(point.x, point.y);
            }
        }
        const std::size_t n = mesh_.n_faces();
        require_all_or_none(arrays_.face_site.size(), n, "faces have sites");
        require_all_or_none(arrays_.whole_sides.size(), n, "faces have a number of whole sides");
        require_all_or_none(arrays_.site_points.size(), n, "faces have the position of a site");
    }

    void take_sites() {
        arrays_.site_weights = mesh_.property(id_.site_weights);
        const std::vector<double>& metric = mesh_.property(id_.metric);
        if (metric.size() == 2) arrays_.metric = Metric(metric[0], metric[1]);
        const std::vector<double>& sites = mesh_.property(id_.sites);
        if (sites.size() < 4) return;
        arrays_.columns = static_cast<int>(sites[0]);
        arrays_.rows = static_cast<int>(sites[1]);
        arrays_.short_edges = sites[2];
        for (std::size_t k = 4; k + 1 < sites.size(); k += 2) {
            arrays_.site_positions.emplace_back(sites[k], sites[k + 1]);
        }
    }

    void require_all_or_none(std::size_t found, std::size_t all, const std::string& what) const {
        if (found == 0 || found == all) return;
        refuse_mesh("only " + to_string(found) + " of " + to_string(all) + " " + what);
    }

    void take_orbits() {
        for (const auto v : mesh_.vertices()) {
            const int orbit = mesh_.property(id_.orbit, v);
            if (orbit < 0 || orbit >= static_cast<int>(mesh_.n_vertices()) ||
                mesh_.property(id_.orbit, VertexHandle(orbit)) != orbit) {
                refuse_mesh("vertex " + to_string(v.idx()) + " has the orbit " + to_string(orbit) +
                            ", which is not a representative");
            }
            if (orbit == v.idx()) continue;
            arrays_.vertex_pairs.push_back(
                {orbit, v.idx(), to_offset(mesh_.property(id_.orbit_offset, v))});
        }
    }

    void take_partners() {
        const std::vector<double>& walls = mesh_.property(id_.walls);
        if (walls.size() == 2) {
            const WallsRow* const row = walls_of_numbers(walls[0], walls[1]);
            if (row == nullptr) refuse_arrays("walls are not stated by 0 and 1");
            arrays_.walls = row->walls;
            arrays_.wall_edges = edges_on_walls(arrays_);
        }
        take_holes(mesh_.property(id_.holes), arrays_);
        const bool may_lack = walls.size() == 2 || !arrays_.holes.empty();
        for (const auto h : mesh_.halfedges()) {
            const bool is_paired = !may_lack || mesh_.property(id_.partner, h) >= 0;
            if (!mesh_.is_boundary(h) || !is_paired) continue;
            const HalfedgeHandle partner = checked_partner(h);
            const Offset offset = to_offset(mesh_.property(id_.partner_offset, h));
            // Take the side of the pair whose translation is positive: the other one has the
            // negative.
            if (offset < Offset{}) continue;
            arrays_.edge_pairs.push_back({.v0 = mesh_.to_vertex_handle(h).idx(),
                                          .v1 = mesh_.from_vertex_handle(h).idx(),
                                          .w0 = mesh_.from_vertex_handle(partner).idx(),
                                          .w1 = mesh_.to_vertex_handle(partner).idx(),
                                          .offset = offset});
        }
    }

    /// The partner of a boundary halfedge, which answers it.
    HalfedgeHandle checked_partner(HalfedgeHandle h) const {
        const HalfedgeHandle partner(mesh_.property(id_.partner, h));
        const bool exists = partner.idx() >= 0 &&
                            partner.idx() < static_cast<int>(mesh_.n_halfedges()) && partner != h;
        const Offset offset = to_offset(mesh_.property(id_.partner_offset, h));
        if (!exists || mesh_.property(id_.partner, partner) != h.idx() ||
            to_offset(mesh_.property(id_.partner_offset, partner)) != -offset ||
            offset == Offset{}) {
            refuse_mesh("boundary halfedge " + to_string(h.idx()) + " has the partner " +
                        to_string(partner.idx()) + ", which does not answer it");
        }
        return partner;
    }

    const Mesh& mesh_;
    const OpenMeshProperties& id_;
    Tile arrays_;
};

}  // namespace

OpenMeshTile openmesh_tile(const Tile& tile) {
    if (!tile.copies.empty()) refuse_arrays("it has copies of vertices");
    if (tile.kind == MeshKind::kVoronoi) return build_mesh<CellMesh>(tile);
    return build_mesh<TriangleMesh>(tile);
}

Tile tile(const OpenMeshTile& mesh) {
    return std::visit(
        []<class Mesh>(const OpenMeshTileOf<Mesh>& source) {
            return ArrayBuilder<Mesh>(source).build();
        },
        mesh);
}

}  // namespace pcvt::plane
