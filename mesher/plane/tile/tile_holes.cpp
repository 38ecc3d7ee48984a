#include "mesher/plane/tile/tile_holes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/tile/tile_edges.hpp"

namespace pcvt::plane {
namespace {

/// The number of ASCII characters, of which names consist.
constexpr std::size_t kCharacters = 128;

class HoleCutter {
   public:
    HoleCutter(Tile tile, const HoleSites& holes) : whole_(std::move(tile)), holes_(holes) {
        tile_ = whole_;
        tile_.holes = holes.names;
    }

    Tile cut() {
        find_holes();
        take_faces();
        number_vertices();
        number_sites();
        pair_vertices();
        take_boundary();
        require_proper_triangles();
        for (int& v : tile_.faces.corners) v = vertex_[v];
        return std::move(tile_);
    }

   private:
    bool stays(int f) const { return hole_[f] < 0; }

    /// Finds the hole of each face.
    void find_holes() {
        for (int f = 0; f < whole_.n_faces(); ++f) {
            checkpoint_each(f);
            int hole = -1;
            if (faces_have_sites(whole_.kind)) {
                hole = holes_.of_site[whole_.face_site[f]];
            } else {
                for (const int v : whole_.faces[f]) {
                    hole = std::max(hole, holes_.of_site[whole_.vertex_site[v]]);
                }
            }
            hole_.push_back(hole);
        }
    }

    template <class Values>
    void keep_faces(Values& values) const {
        if (values.empty()) return;
        Values kept;
        for (int f = 0; f < whole_.n_faces(); ++f) {
            if (stays(f)) kept.push_back(values[f]);
        }
        values = std::move(kept);
    }

    void take_faces() {
        tile_.faces = {};
        for (int f = 0; f < whole_.n_faces(); ++f) {
            checkpoint_each(f);
            if (!stays(f)) continue;
            tile_.faces.add(whole_.faces[f]);
            int from = whole_.faces[f].back();
            for (const int v : whole_.faces[f]) sides_.emplace_back(std::exchange(from, v), v);
        }
        cancellable_sort(sides_.begin(), sides_.end(), std::less<>());
        keep_faces(tile_.face_site);
        keep_faces(tile_.site_points);
        keep_faces(tile_.grain_site_points);
        keep_faces(tile_.whole_sides);
    }

    /// Whether a face that stays runs from v to w.
    bool has_side(int v, int w) const {
        return std::binary_search(sides_.begin(), sides_.end(), std::pair(v, w));
    }

    void number_vertices() {
        std::vector<bool> used(whole_.points.size(), false);
        for (const int v : tile_.faces.corners) used[v] = true;
        tile_.points.clear();
        tile_.vertex_site.clear();
        for (int v = 0; v < whole_.n_vertices(); ++v) {
            vertex_.push_back(used[v] ? tile_.n_vertices() : -1);
            if (!used[v]) continue;
            tile_.points.push_back(whole_.points[v]);
            if (!whole_.vertex_site.empty()) tile_.vertex_site.push_back(whole_.vertex_site[v]);
        }
    }

    void number_sites() {
        std::vector<SiteId> number(holes_.of_site.size(), -1);
        SiteId next = 0;
        for (const SiteId s : holes_.kept()) number[s] = next++;
        for (std::vector<SiteId>* sites : {&tile_.face_site, &tile_.vertex_site}) {
            for (SiteId& s : *sites) s = number[s];
        }
    }

    /// The first vertex that stays represents its orbit.
    void pair_vertices() {
        std::vector<VertexPair> in_orbit;
        for (int v = 0; v < whole_.n_vertices(); ++v) in_orbit.push_back({v, v, Offset{}});
        for (const VertexPair& pair : whole_.vertex_pairs) in_orbit[pair.w] = pair;
        std::vector<int> first(whole_.points.size(), -1);
        tile_.vertex_pairs.clear();
        for (const auto& [orbit, w, offset] : in_orbit) {
            if (vertex_[w] < 0) continue;
            if (first[orbit] < 0) {
                first[orbit] = w;
                continue;
            }
            const int v = first[orbit];
            tile_.vertex_pairs.push_back({vertex_[v], vertex_[w], offset - in_orbit[v].offset});
        }
    }

    void add_wall(WallId wall, int v, int w) {
        tile_.wall_edges.push_back({wall, vertex_[v], vertex_[w]});
    }

    void take_boundary() {
        tile_.edge_pairs.clear();
        for (const auto& [v0, v1, w0, w1, offset] : whole_.edge_pairs) {
            if (!has_side(v0, v1) || !has_side(w1, w0)) continue;
            tile_.edge_pairs.push_back(
                {vertex_[v0], vertex_[v1], vertex_[w0], vertex_[w1], offset});
        }
        tile_.wall_edges.clear();
        for (const auto& [wall, v, w] : whole_.wall_edges) {
            if (has_side(v, w)) add_wall(wall, v, w);
        }
        for (const TileEdge& edge : tile_edges(whole_)) {
            if (edge.right < 0 || stays(edge.left) == stays(edge.right)) continue;
            if (stays(edge.left)) {
                add_wall(WallId::hole(hole_[edge.right]), edge.v, edge.w);
            } else if (!edge.on_seam) {
                add_wall(WallId::hole(hole_[edge.left]), edge.w, edge.v);
            }
        }
        std::sort(tile_.wall_edges.begin(), tile_.wall_edges.end());
    }

    /// Between two holes, or in a corner of one, the triangles at their sites may leave no others.
    void require_proper_triangles() const {
        if (tile_.kind != MeshKind::kDelaunay) return;
        std::vector<bool> has_vertex(holes_.kept().size(), false);
        for (const SiteId s : tile_.vertex_site) has_vertex[s] = true;
        std::vector<int> orbit(tile_.points.size());
        std::iota(orbit.begin(), orbit.end(), 0);
        for (const VertexPair& pair : tile_.vertex_pairs) orbit[pair.w] = pair.v;
        std::vector<bool> leaves(tile_.points.size(), false);
        bool is_proper = std::find(has_vertex.begin(), has_vertex.end(), false) == has_vertex.end();
        for (const auto& [wall, v, w] : tile_.wall_edges) {
            if (!wall.is_hole()) continue;
            is_proper = is_proper && !leaves[orbit[v]];
            leaves[orbit[v]] = true;
        }
        if (is_proper) return;
        throw InvalidInput(
            "the Delaunay triangles outside of the holes are not a surface, because holes are too "
            "near to each other; take the mesh grains, or more sites");
    }

    Tile whole_;
    const HoleSites& holes_;
    Tile tile_{.lattice = Lattice::rectangle(1, 1), .kind = MeshKind::kVoronoi};
    /// The hole in which each face lies; -1: the face stays.
    std::vector<int> hole_;
    /// From one vertex to the next, of the faces that stay; sorted.
    std::vector<std::pair<int, int>> sides_;
    /// The new number of each vertex, -1 for those that no face needs.
    std::vector<int> vertex_;
};

/// Leaves faces out of a mesh of the torus.
class TorusCutter {
   public:
    TorusCutter(const PeriodicMesh& whole, const HoleSites& holes)
        : whole_(whole), holes_(holes), mesh_{.lattice = whole.lattice, .kind = whole.kind} {}

    PeriodicMesh cut() {
        number_sites();
        vertex_.assign(whole_.vertices.size(), -1);
        corner_.assign(whole_.corner_vertex.size(), -1);
        for (int f = 0; f < whole_.n_faces(); ++f) {
            checkpoint_each(f);
            if (stays(f)) add_face(f);
        }
        for (std::size_t c = 0; c < corner_.size(); ++c) {
            if (corner_[c] < 0) continue;
            const int across = whole_.opposite[c];
            mesh_.opposite.push_back(across < 0 ? -1 : corner_[across]);
        }
        return std::move(mesh_);
    }

   private:
    void number_sites() {
        site_.assign(holes_.of_site.size(), -1);
        SiteId next = 0;
        for (const SiteId s : holes_.kept()) site_[s] = next++;
    }

    bool stays(int f) const {
        if (faces_have_sites(whole_.kind)) return site_[whole_.site[f]] >= 0;
        for (int c = whole_.face_begin[f]; c < whole_.face_begin[f + 1]; ++c) {
            if (site_[whole_.site[whole_.corner_vertex[c]]] < 0) return false;
        }
        return true;
    }

    void add_face(int f) {
        for (int c = whole_.face_begin[f]; c < whole_.face_begin[f + 1]; ++c) {
            corner_[c] = mesh_.n_corners();
            mesh_.corner_vertex.push_back(placed(whole_.corner_vertex[c]));
            mesh_.corner_offset.push_back(whole_.corner_offset[c]);
            mesh_.corner_face.push_back(mesh_.n_faces());
        }
        mesh_.face_begin.push_back(mesh_.n_corners());
        if (faces_have_sites(whole_.kind)) mesh_.site.push_back(site_[whole_.site[f]]);
        if (!whole_.site_points.empty()) mesh_.site_points.push_back(whole_.site_points[f]);
        if (!whole_.whole_sides.empty()) mesh_.whole_sides.push_back(whole_.whole_sides[f]);
    }

    /// The number of a vertex, which is new if no face before has it.
    int placed(int v) {
        if (vertex_[v] < 0) {
            vertex_[v] = mesh_.n_vertices();
            mesh_.vertices.push_back(whole_.vertices[v]);
            if (!faces_have_sites(whole_.kind)) mesh_.site.push_back(site_[whole_.site[v]]);
        }
        return vertex_[v];
    }

    const PeriodicMesh& whole_;
    const HoleSites& holes_;
    PeriodicMesh mesh_;
    /// The new numbers of sites, vertices and corners; -1: left out.
    std::vector<SiteId> site_;
    std::vector<int> vertex_;
    std::vector<int> corner_;
};

/// Takes numbers from the front of a list of integers.
class NumberList {
   public:
    explicit NumberList(std::span<const double> numbers) : rest_(numbers) {}

    bool is_at_end() const { return rest_.empty(); }
    /// An integer from 0 to limit - 1.
    int take(std::size_t limit) {
        if (rest_.empty() || !(rest_[0] >= 0 && rest_[0] < double(limit)) ||
            rest_[0] != std::floor(rest_[0])) {
            throw InvalidInput("the list of holes is damaged; write the file again");
        }
        const auto number = static_cast<int>(rest_[0]);
        rest_ = rest_.subspan(1);
        return number;
    }

   private:
    std::span<const double> rest_;
};

}  // namespace

Tile with_holes(Tile tile, const HoleSites& holes) {
    if (holes.empty()) return tile;
    return HoleCutter(std::move(tile), holes).cut();
}

PeriodicMesh with_holes(PeriodicMesh mesh, const HoleSites& holes) {
    if (holes.empty()) return mesh;
    return TorusCutter(mesh, holes).cut();
}

std::vector<double> holes_as_numbers(const Tile& tile) {
    if (tile.holes.empty()) return {};
    std::vector<double> numbers{double(tile.holes.size())};
    for (const std::string& name : tile.holes) {
        numbers.push_back(double(name.size()));
        for (const char c : name) numbers.push_back(c);
    }
    for (const auto& [wall, v, w] : tile.wall_edges) {
        if (!wall.is_hole()) continue;
        for (const int number : {wall.hole(), v, w}) numbers.push_back(number);
    }
    return numbers;
}

void take_holes(std::span<const double> numbers, Tile& tile) {
    if (numbers.empty()) return;
    NumberList list(numbers);
    for (int left = list.take(numbers.size()); left > 0; --left) {
        std::string name;
        for (int n = list.take(numbers.size()); n > 0; --n) {
            name += static_cast<char>(list.take(kCharacters));
        }
        tile.holes.push_back(name);
    }
    while (!list.is_at_end()) {
        const int hole = list.take(tile.holes.size());
        const int v = list.take(tile.points.size());
        tile.wall_edges.push_back({WallId::hole(hole), v, list.take(tile.points.size())});
    }
    std::sort(tile.wall_edges.begin(), tile.wall_edges.end());
}

}  // namespace pcvt::plane
