#include "mesher/plane/proof/validate_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/plane/proof/vertex_orbits.hpp"
#include "mesher/plane/tile/site_positions.hpp"

namespace pcvt::plane {
namespace {

using std::to_string;

const char* const kWallLaw = "(6), walls";

/// Bounds the rounding errors of the representative, of the period and of their sum, in ulps.
constexpr double kTranslationUlps = 4;

/// The largest coordinate of the domain from which the vertices of elongated cells come, length
/// units; 0 without elongation. The basis of that domain is reduced in the metric of the cells and
/// may be longer than the tile. Vertices, and their translations into the tile, are rounded at that
/// size.
double farthest_summand(const Tile& tile) {
    if (tile.metric.is_round()) return 0;
    const Lattice reduced = reduce(tile.metric.to_round(tile.lattice)).reduced;
    return (tile.metric.from_round(reduced.a()).cwiseAbs() +
            tile.metric.from_round(reduced.b()).cwiseAbs())
        .maxCoeff();
}

/// The wall on which an edge of a proven tile between walls lies.
WallSide wall_of(const Tile& tile, int v, int w) {
    double nearest = std::numeric_limits<double>::infinity();
    WallSide side{};
    for (const WallSideRow& row : kWallSides) {
        if (!has_walls_across(tile.walls, row.axis)) continue;
        const double line = wall_line(row, tile.lattice);
        const double off = std::max(std::abs(tile.points[v][row.axis] - line),
                                    std::abs(tile.points[w][row.axis] - line));
        if (off < nearest) {
            nearest = off;
            side = row.side;
        }
    }
    return side;
}

/// Takes the faces of the tile, which come first, and their edges on walls.
void take_faces(const Tile& tile, const GluedFaces& all, Gluing& part) {
    GluedFaces& faces = part.faces;
    for (int f = 0; f < all.n_faces() && all.file_face[f] < tile.n_faces(); ++f) {
        faces.add(all[f]);
        faces.file_face.push_back(all.file_face[f]);
    }
    const int n_halfedges = static_cast<int>(faces.corners.size());
    faces.face_of.assign(all.face_of.begin(), all.face_of.begin() + n_halfedges);
    faces.opposite.assign(all.opposite.begin(), all.opposite.begin() + n_halfedges);
    faces.across.assign(all.across.begin(), all.across.begin() + n_halfedges);
    for (int h = 0; h < n_halfedges; ++h) {
        checkpoint_each(h);
        if (faces.opposite[h] < n_halfedges) continue;
        const int v = faces.corners[h];
        const int w = faces.corners[faces.next(h)];
        part.proof.wall_edges.push_back({WallId::side(wall_of(tile, v, w)), v, w});
        faces.put_on_wall(h);
    }
    const int n_points = tile.n_vertices() - static_cast<int>(tile.copies.size());
    for (const WallEdge& edge : all.hole_edges) {
        if (std::max(edge.v0, edge.v1) < n_points) faces.hole_edges.push_back(edge);
    }
    part.proof.wall_edges.insert(part.proof.wall_edges.end(), faces.hole_edges.begin(),
                                 faces.hole_edges.end());
    std::sort(part.proof.wall_edges.begin(), part.proof.wall_edges.end());
    part.proof.n_faces = faces.n_faces();
}

/// Takes the orbits of the tile's vertices. The representative of an orbit is its first vertex,
/// therefore one of the tile.
void take_vertices(const Tile& tile, const TileProof& torus, Gluing& part) {
    TileProof& proof = part.proof;
    const int n_points = tile.n_vertices() - static_cast<int>(tile.copies.size());
    std::vector<bool> in_faces(static_cast<std::size_t>(n_points), false);
    for (const int v : part.faces.corners) in_faces[v] = true;
    const VertexOrbits orbits = proven_orbits(torus);
    for (int v = 0; v < n_points; ++v) {
        checkpoint_each(v);
        const int first = torus.first_copy[v];
        proof.first_copy.push_back(first);
        if (first != v) {
            ++proof.n_merged;
            continue;
        }
        if (in_faces[v]) ++proof.n_vertices;
        if (orbits.representative[v] == v) {
            ++proof.n_orbits;
        } else {
            proof.vertex_pairs.push_back({orbits.representative[v], v, orbits.offset[v]});
        }
    }
    for (const int v : tile.copies) {
        proof.first_copy.push_back(proof.first_copy[v]);
        ++proof.n_merged;
    }
}

/// Replaces copies of vertices by the vertices that they repeat.
void drop_copies(Tile& tile) {
    if (tile.copies.empty()) return;
    const std::size_t n = tile.points.size() - tile.copies.size();
    for (int& v : tile.faces.corners) {
        if (static_cast<std::size_t>(v) >= n) v = tile.copies[static_cast<std::size_t>(v) - n];
    }
    tile.points.resize(n);
    if (!tile.vertex_site.empty()) tile.vertex_site.resize(n);
    tile.copies.clear();
}

/// The images of a tile across one axis.
class Mirror {
   public:
    Mirror(Tile& tile, int axis)
        : tile_(tile), axis_(axis), end_(side_length(tile.lattice, axis)) {}

    void add_images() {
        number_sites();
        add_vertices();
        add_faces();
        add_holes();
        const bool across_x = axis_ == 0;
        tile_.lattice = tile_.lattice.repeated(across_x ? 2 : 1, across_x ? 1 : 2);
    }

   private:
    Vec2 image(Vec2 p) const {
        p[axis_] = p[axis_] == 0 ? 0 : -p[axis_];
        return p;
    }

    bool on_wall(const Vec2& p) const { return p[axis_] == 0 || p[axis_] == end_; }

    /// Whether each site lies on the wall, as far as its position shows.
    std::vector<bool> sites_on_wall(std::size_t n) const {
        std::vector<bool> found(n, false);
        const std::vector<Vec2> positions = site_positions(tile_);
        for (std::size_t s = 0; s < std::min(n, positions.size()); ++s) {
            found[s] = on_wall(positions[s]);
        }
        if (tile_.kind != MeshKind::kDelaunay) return found;
        for (std::size_t v = 0; v < tile_.vertex_site.size(); ++v) {
            const SiteId site = tile_.vertex_site[v];
            const bool known = site >= 0 && static_cast<std::size_t>(site) < n;
            if (known && on_wall(tile_.points[v])) found[static_cast<std::size_t>(site)] = true;
        }
        return found;
    }

    void number_sites() {
        SiteId last = -1;
        for (const SiteId site : tile_.sites()) last = std::max(last, site);
        const auto n = static_cast<std::size_t>(std::int64_t{last} + 1);
        // Wrong ids of a file may be very large; the proof refuses them in the tile itself.
        if (n > tile_.sites().size() + tile_.site_positions.size()) return;
        const std::vector<bool> own = sites_on_wall(n);
        auto next = static_cast<SiteId>(n);
        const bool has_weights = tile_.site_weights.size() == n;
        const bool has_positions = tile_.site_positions.size() == n;
        for (std::size_t s = 0; s < n; ++s) {
            image_site_.push_back(own[s] ? static_cast<SiteId>(s) : next++);
            if (own[s]) continue;
            if (has_weights) tile_.site_weights.push_back(tile_.site_weights[s]);
            if (has_positions) tile_.site_positions.push_back(image(tile_.site_positions[s]));
        }
    }

    SiteId image_site(SiteId site) const {
        const bool known = site >= 0 && static_cast<std::size_t>(site) < image_site_.size();
        return known ? image_site_[static_cast<std::size_t>(site)] : site;
    }

    void add_vertices() {
        const int n = tile_.n_vertices();
        const bool has_sites = !tile_.vertex_site.empty();
        for (int v = 0; v < n; ++v) {
            checkpoint_each(v);
            const Vec2 p = tile_.points[v];
            if (p[axis_] == 0) {
                image_vertex_.push_back(v);
                continue;
            }
            image_vertex_.push_back(tile_.n_vertices());
            tile_.points.push_back(image(p));
            if (has_sites) tile_.vertex_site.push_back(image_site(tile_.vertex_site[v]));
        }
    }

    void add_faces() {
        const int n = tile_.n_faces();
        for (int begin = 0; begin < n;) {
            int end = begin + 1;
            while (end < n && continues_fan(end)) ++end;
            for (int f = end - 1; f >= begin; --f) add_face(f);
            begin = end;
        }
    }

    /// Whether a face and the one before it are triangles of one fan.
    bool continues_fan(int f) const {
        checkpoint_each(f);
        const auto before = tile_.faces[f - 1];
        const auto face = tile_.faces[f];
        const auto k = static_cast<std::size_t>(f);
        const bool same_site =
            k >= tile_.face_site.size() || tile_.face_site[k] == tile_.face_site[k - 1];
        return same_site && before.size() == 3 && face.size() == 3 && face[0] == before[0] &&
               face[1] == before[2];
    }

    void add_face(int f) {
        const int begin = tile_.faces.begin[f];
        const int end = tile_.faces.begin[f + 1];
        tile_.faces.corners.push_back(image_vertex_[tile_.faces.corners[begin]]);
        for (int c = end - 1; c > begin; --c) {
            tile_.faces.corners.push_back(image_vertex_[tile_.faces.corners[c]]);
        }
        tile_.faces.close();
        add_attributes(f);
    }

    void add_holes() {
        const std::vector<WallEdge> edges = tile_.wall_edges;
        for (const auto& [wall, v, w] : edges) {
            if (!wall.is_hole()) continue;
            tile_.wall_edges.push_back({wall, image_vertex_[w], image_vertex_[v]});
        }
    }

    void add_attributes(int f) {
        const auto k = static_cast<std::size_t>(f);
        if (k < tile_.face_site.size()) tile_.face_site.push_back(image_site(tile_.face_site[k]));
        if (k < tile_.whole_sides.size()) tile_.whole_sides.push_back(tile_.whole_sides[k]);
        for (std::vector<Vec2>* points : {&tile_.site_points, &tile_.grain_site_points}) {
            if (k < points->size()) points->push_back(image((*points)[k]));
        }
    }

    Tile& tile_;
    int axis_;
    double end_;
    std::vector<SiteId> image_site_;
    std::vector<int> image_vertex_;
};

}  // namespace

double position_tolerance(const Tile& tile, Precision precision) {
    double largest = 0;
    for (const Vec2& p : tile.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    if (precision == Precision::kDouble) largest = std::max(largest, farthest_summand(tile));
    int exponent = 0;
    std::frexp(largest, &exponent);
    const int digits = precision == Precision::kDouble ? std::numeric_limits<double>::digits
                                                       : std::numeric_limits<float>::digits;
    return kTranslationUlps * std::ldexp(1.0, exponent - digits);
}

void require_between_walls(const Tile& tile, Precision precision) {
    if (!is_upright(tile.lattice)) {
        throw_violation(kWallLaw, "walls need the period vectors (width, 0) and (0, height)");
    }
    const double tolerance = position_tolerance(tile, precision);
    for (const WallSideRow& row : kWallSides) {
        if (!has_walls_across(tile.walls, row.axis)) continue;
        const double line = wall_line(row, tile.lattice);
        for (int v = 0; v < tile.n_vertices(); ++v) {
            checkpoint_each(v);
            const double beyond = (tile.points[v][row.axis] - line) * (row.at_end ? 1 : -1);
            if (beyond == 0 || beyond < -tolerance) continue;
            if (precision == Precision::kSingle && beyond <= tolerance) continue;
            throw_violation(kWallLaw, "vertex " + to_string(v) + " lies off " + row.word + " by " +
                                          in_words(beyond));
        }
    }
}

Tile with_exact_walls(Tile tile, double tolerance) {
    for (const WallSideRow& row : kWallSides) {
        if (!has_walls_across(tile.walls, row.axis)) continue;
        const double line = wall_line(row, tile.lattice);
        for (std::vector<Vec2>* points : {&tile.points, &tile.site_positions}) {
            for (Vec2& p : *points) {
                if (std::abs(p[row.axis] - line) <= tolerance) p[row.axis] = line;
            }
        }
    }
    return tile;
}

Tile mirrored_tile(Tile tile) {
    drop_copies(tile);
    for (int axis = 0; axis < 2; ++axis) {
        if (has_walls_across(tile.walls, axis)) Mirror(tile, axis).add_images();
    }
    tile.walls = Walls::kNone;
    std::erase_if(tile.wall_edges, [](const WallEdge& edge) { return !edge.wall.is_hole(); });
    tile.vertex_pairs.clear();
    tile.edge_pairs.clear();
    return tile;
}

Gluing part_of_tile(const Tile& tile, const Gluing& torus) {
    Gluing part;
    TileProof& proof = part.proof;
    proof.precision = torus.proof.precision;
    proof.tolerance = torus.proof.tolerance;
    proof.mismatch = torus.proof.mismatch;
    take_faces(tile, torus.faces, part);
    take_vertices(tile, torus.proof, part);
    const int n_points = tile.n_vertices() - static_cast<int>(tile.copies.size());
    for (const EdgePair& pair : torus.proof.edge_pairs) {
        if (std::max({pair.v0, pair.v1, pair.w0, pair.w1}) < n_points) {
            proof.edge_pairs.push_back(pair);
        }
    }
    proof.n_boundary_edges =
        static_cast<int>(2 * proof.edge_pairs.size() + proof.wall_edges.size());
    proof.area = torus.proof.area / n_images(tile.walls);
    return part;
}

}  // namespace pcvt::plane
