#include "mesher/plane/mesh/short_edges.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/torus/offset_disjoint_sets.hpp"

namespace pcvt::plane {
namespace {

/// A cell keeps at least this fraction of its area when an edge is removed.
constexpr double kAreaWithoutEdge = 0.5;

/// The mesh while vertices are being joined. A corner of an old face lies at the root of its
/// vertex.
class Shrinking {
   public:
    /// @param domain  nullptr: the mesh is that of a torus.
    explicit Shrinking(const PeriodicMesh& mesh, const WalledDomain* domain = nullptr)
        : mesh_(mesh),
          joined_(mesh.n_vertices()),
          position_(mesh.vertices),
          corners_at_(mesh.vertices.size()),
          walls_(mesh.vertices.size()) {
        for (int c = 0; c < mesh.n_corners(); ++c) {
            corners_at_[mesh.corner_vertex[c]].push_back(c);
            if (mesh.opposite[c] >= 0) continue;
            const WallSideRow& wall = wall_side_of(mesh, c, *domain);
            for (const int end : {c, mesh.next(c)}) {
                walls_[mesh.corner_vertex[end]][wall.axis] = wall_line(wall, domain->lattice);
            }
        }
        for (int v = 0; v < mesh.n_vertices(); ++v) weight_.push_back(weight_of(v));
    }

    /// @param still  for each vertex of the mesh.
    void keep(std::vector<bool> still) { is_still_ = std::move(still); }

    MeshCorner corner(int c) {
        const auto root = joined_.root(mesh_.corner_vertex[c]);
        return {root.orbit, root.offset + mesh_.corner_offset[c]};
    }
    Vec2 point(const MeshCorner& corner) const {
        return position_[corner.vertex] + mesh_.lattice.translation(corner.offset);
    }
    /// Returns the corners of face f; joined corners occur once.
    std::vector<MeshCorner> corners_of(int f) {
        std::vector<MeshCorner> corners;
        for (int c = mesh_.face_begin[f]; c < mesh_.face_begin[f + 1]; ++c) {
            if (corners.empty() || corners.back() != corner(c)) corners.push_back(corner(c));
        }
        while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
        return corners;
    }
    /// Returns the length of the edge; 0 if its ends are joined already.
    double length(int c) { return (point(corner(mesh_.next(c))) - point(corner(c))).norm(); }
    /// Whether the ends of the edge are different orbits: an edge between two images of one vertex
    /// cannot be removed.
    bool joins_orbits(int c) {
        return joined_.root(mesh_.corner_vertex[c]).orbit !=
               joined_.root(mesh_.corner_vertex[mesh_.next(c)]).orbit;
    }

    /// Shrinks the edge that corner c leaves, unless that would tear or squash a cell.
    bool shrink(int c) {
        const MeshCorner from = corner(c);
        const MeshCorner to = corner(mesh_.next(c));
        if (!is_still_.empty() && (is_still_[from.vertex] || is_still_[to.vertex])) return false;
        const std::optional<Pinned> pinned = united(walls_[from.vertex], walls_[to.vertex]);
        const int weight = weight_[from.vertex] + weight_[to.vertex];
        // The middle of a cell whose site lies in a corner of walls cannot be a corner of the cell.
        const bool is_site = weight_[from.vertex] < 0 || weight_[to.vertex] < 0;
        if (!pinned || weight == 0 || is_site) return false;
        Vec2 middle =
            (weight_[from.vertex] * point(from) + weight_[to.vertex] * point(to)) / weight;
        for (int axis = 0; axis < 2; ++axis) {
            if ((*pinned)[axis]) middle[axis] = *(*pinned)[axis];
        }
        for (const int v : {from.vertex, to.vertex}) {
            for (const int d : corners_at_[v]) {
                if (!survives(mesh_.corner_face[d], from, to, middle)) return false;
            }
        }
        join(from, to, middle);
        walls_[corner(c).vertex] = *pinned;
        return true;
    }

    /// Moves the places where edges between cells of sites on walls cross the walls to where these
    /// edges, whose other ends may have moved, cross them now: at right angles.
    void straighten_crossings() {
        for (int c = 0; c < mesh_.n_corners(); ++c) {
            checkpoint_each(c);
            if (mesh_.opposite[c] < 0) continue;
            const MeshCorner at = corner(c);
            const MeshCorner end = corner(mesh_.next(c));
            const Pinned& wall = walls_[at.vertex];
            if (weight_[at.vertex] != 0 || weight_[end.vertex] == 0) continue;
            const int along = wall[0] ? 1 : 0;
            position_[at.vertex][along] =
                (point(end) - mesh_.lattice.translation(at.offset))[along];
        }
    }

    PeriodicMesh result() {
        PeriodicMesh mesh{.lattice = mesh_.lattice, .kind = mesh_.kind, .site = mesh_.site};
        mesh.site_points = mesh_.site_points;
        mesh.whole_sides = mesh_.whole_sides;
        std::vector<int> number(position_.size(), -1);
        for (int v = 0; v < mesh_.n_vertices(); ++v) {
            checkpoint_each(v);
            if (joined_.root(v).orbit != v) continue;
            number[v] = mesh.n_vertices();
            mesh.vertices.push_back(position_[v]);
        }
        for (int f = 0; f < mesh_.n_faces(); ++f) {
            checkpoint_each(f);
            for (const MeshCorner& corner : corners_of(f)) {
                mesh.corner_vertex.push_back(number[corner.vertex]);
                mesh.corner_offset.push_back(corner.offset);
            }
            mesh.face_begin.push_back(mesh.n_corners());
        }
        return mesh;
    }

   private:
    /// For each axis the place of the wall on which a vertex lies.
    using Pinned = std::array<std::optional<double>, 2>;

    /// `nullopt` for vertices on opposite walls.
    static std::optional<Pinned> united(const Pinned& first, const Pinned& second) {
        Pinned both = first;
        for (int axis = 0; axis < 2; ++axis) {
            if (both[axis] && second[axis] && *both[axis] != *second[axis]) return std::nullopt;
            if (!both[axis]) both[axis] = second[axis];
        }
        return both;
    }

    /// The number of Delaunay triangles whose circumcentres lie at a vertex: two less than that of
    /// its cells. On a wall the cells of the images count too, and the vertex has a half of the
    /// triangles, in a corner of walls a quarter. In quarters of a triangle.
    int weight_of(int v) const {
        int n_cells = 0;
        int n_images = 1;
        for (int axis = 0; axis < 2; ++axis) n_images *= walls_[v][axis] ? 2 : 1;
        for (const int c : corners_at_[v]) {
            int n = 1;
            for (int axis = 0; axis < 2; ++axis) {
                const auto& wall = walls_[v][axis];
                // A cell whose site lies on the wall is its own image.
                if (wall && mesh_.site_points[mesh_.corner_face[c]][axis] != *wall) n *= 2;
            }
            n_cells += n;
        }
        return 4 * (n_cells - 2) / n_images;
    }

    /// Moves the crossings of a polygon, one corner for each corner of face f, as
    /// straighten_crossings() will.
    void straighten(int f, Polygon& polygon) {
        const int begin = mesh_.face_begin[f];
        const int n = mesh_.face_begin[f + 1] - begin;
        for (int k = 0; k < n; ++k) {
            const int v = corner(begin + k).vertex;
            if (weight_[v] != 0) continue;
            const int before = (k + n - 1) % n;
            const bool is_first = mesh_.opposite[begin + k] >= 0;
            if (!is_first && mesh_.opposite[begin + before] < 0) continue;
            const int end = is_first ? (k + 1) % n : before;
            if (weight_[corner(begin + end).vertex] == 0) continue;
            const int along = walls_[v][0] ? 1 : 0;
            polygon[k][along] = polygon[end][along];
        }
    }

    /// Whether face f remains a polygon when `to` joins `from` at the position `middle`; all three
    /// are in the same frame.
    bool survives(int f, const MeshCorner& from, const MeshCorner& to, const Vec2& middle) {
        std::vector<MeshCorner> moved;
        Polygon old_polygon;
        Polygon new_polygon;
        for (int c = mesh_.face_begin[f]; c < mesh_.face_begin[f + 1]; ++c) {
            const MeshCorner old = corner(c);
            old_polygon.push_back(point(old));
            const bool moves = old.vertex == from.vertex || old.vertex == to.vertex;
            const Offset frame = old.offset - (old.vertex == to.vertex ? to : from).offset;
            moved.push_back(moves ? MeshCorner{from.vertex, from.offset + frame} : old);
            new_polygon.push_back(moves ? Vec2(middle + mesh_.lattice.translation(frame))
                                        : point(old));
        }
        straighten(f, new_polygon);
        // Drop repeated corners.
        std::vector<MeshCorner> after;
        Polygon polygon;
        for (std::size_t k = 0; k < moved.size(); ++k) {
            if (moved[k] == moved[(k + 1) % moved.size()]) continue;
            after.push_back(moved[k]);
            polygon.push_back(new_polygon[k]);
        }
        // Check that the corners are distinct and the polygon is simple and large enough.
        std::sort(after.begin(), after.end());
        return after.size() >= 3 && std::adjacent_find(after.begin(), after.end()) == after.end() &&
               polygon_area(polygon) >= kAreaWithoutEdge * polygon_area(old_polygon) &&
               !crosses_itself(polygon, 0);
    }

    void join(const MeshCorner& from, const MeshCorner& to, const Vec2& middle) {
        const int weight = weight_[from.vertex] + weight_[to.vertex];
        joined_.join(from.vertex, to.vertex, to.offset - from.offset);
        // One of the two is the root now.
        const bool stays = joined_.root(from.vertex).orbit == from.vertex;
        const MeshCorner& root = stays ? from : to;
        const MeshCorner& other = stays ? to : from;
        position_[root.vertex] = middle - mesh_.lattice.translation(root.offset);
        weight_[root.vertex] = weight;
        std::vector<int>& corners = corners_at_[other.vertex];
        corners_at_[root.vertex].insert(corners_at_[root.vertex].end(), corners.begin(),
                                        corners.end());
        corners.clear();
    }

    const PeriodicMesh& mesh_;
    OffsetDisjointSets<Offset> joined_;
    /// The position of each root.
    std::vector<Vec2> position_;
    std::vector<std::vector<int>> corners_at_;
    /// The coordinates at which walls hold each root.
    std::vector<Pinned> walls_;
    /// Whether each vertex of the mesh stays where it is; empty: all may move.
    std::vector<bool> is_still_;
    /// The sum of weight_of() over the vertices that were joined to each root.
    std::vector<int> weight_;
};

/// Returns one halfedge of each edge shorter than `shortest`, the shortest edge first.
std::vector<int> short_halfedges(const PeriodicMesh& cells, Shrinking& shrinking, double shortest) {
    std::vector<std::tuple<double, int>> found;
    for (int c = 0; c < cells.n_corners(); ++c) {
        checkpoint_each(c);
        const bool is_second_side = cells.opposite[c] >= 0 && cells.opposite[c] < c;
        if (is_second_side || !shrinking.joins_orbits(c)) continue;
        const double length = shrinking.length(c);
        if (length < shortest) found.emplace_back(length, c);
    }
    std::sort(found.begin(), found.end());
    std::vector<int> halfedges;
    for (const auto& [length, c] : found) halfedges.push_back(c);
    return halfedges;
}

PeriodicMesh shrunk(const PeriodicMesh& cells, Shrinking shrinking, double shortest) {
    for (bool changed = true; changed;) {
        changed = false;
        for (const int c : short_halfedges(cells, shrinking, shortest)) {
            checkpoint();
            // The removal of a neighbouring edge may have changed this one.
            if (!shrinking.joins_orbits(c) || !(shrinking.length(c) < shortest)) continue;
            changed = shrinking.shrink(c) || changed;
        }
    }
    shrinking.straighten_crossings();
    return shrinking.result();
}

}  // namespace

PeriodicMesh without_short_edges(const PeriodicMesh& cells, double shortest,
                                 std::vector<bool> still) {
    Shrinking shrinking(cells);
    shrinking.keep(std::move(still));
    PeriodicMesh result = shrunk(cells, std::move(shrinking), shortest);
    link_faces(result);
    return result;
}

PeriodicMesh without_short_edges(const PeriodicMesh& between, double shortest,
                                 const WalledDomain& domain, std::vector<bool> still) {
    Shrinking shrinking(between, &domain);
    shrinking.keep(std::move(still));
    return shrunk(between, std::move(shrinking), shortest);
}

}  // namespace pcvt::plane
