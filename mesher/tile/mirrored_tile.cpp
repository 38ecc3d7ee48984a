#include "mesher/tile/mirrored_tile.hpp"

#include <algorithm>

#include "mesher/base/checkpoint.hpp"
#include "mesher/tile/site_positions.hpp"

namespace pcvt {
namespace {

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
        const bool across_x = axis_ == 0;
        tile_.lattice = tile_.lattice.repeated(across_x ? 2 : 1, across_x ? 1 : 2);
    }

   private:
    Vec2 image(Vec2 p) const {
        p[axis_] = p[axis_] == 0 ? 0 : -p[axis_];
        return p;
    }

    bool on_wall(const Vec2& p) const { return p[axis_] == 0 || p[axis_] == end_; }

    /// Whether each site lies on the wall, as far as positions tell.
    std::vector<bool> sites_on_wall(std::size_t n) const {
        std::vector<bool> on_wall_(n, false);
        const std::vector<Vec2> positions = site_positions(tile_);
        for (std::size_t s = 0; s < std::min(n, positions.size()); ++s) {
            on_wall_[s] = on_wall(positions[s]);
        }
        if (tile_.kind != MeshKind::kDelaunay) return on_wall_;
        for (std::size_t v = 0; v < tile_.vertex_site.size(); ++v) {
            const SiteId site = tile_.vertex_site[v];
            const bool known = site >= 0 && static_cast<std::size_t>(site) < n;
            if (known && on_wall(tile_.points[v])) on_wall_[static_cast<std::size_t>(site)] = true;
        }
        return on_wall_;
    }

    void number_sites() {
        SiteId last = -1;
        for (const SiteId site : tile_.sites()) last = std::max(last, site);
        const auto n = static_cast<std::size_t>(last + 1);
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

    /// Whether a face continues the fan of the triangle before it.
    bool continues_fan(int f) const {
        const auto k = static_cast<std::size_t>(f);
        if (tile_.kind != MeshKind::kVoronoi || k >= tile_.face_site.size()) return false;
        return tile_.face_site[k] == tile_.face_site[k - 1] &&
               tile_.faces[f][0] == tile_.faces[f - 1][0] &&
               tile_.faces[f][1] == tile_.faces[f - 1].back();
    }

    /// Adds the images in the order of the faces, so that the first face of a site becomes the
    /// first one of its image; the triangles of a fan in the opposite order, which is that of their
    /// images.
    void add_faces() {
        const int n = tile_.n_faces();
        for (int first = 0, end = 0; first < n; first = end) {
            checkpoint_each(first);
            end = first + 1;
            while (end < n && continues_fan(end)) ++end;
            for (int f = end - 1; f >= first; --f) add_face(f);
        }
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

Tile mirrored_tile(Tile tile) {
    drop_copies(tile);
    for (int axis = 0; axis < 2; ++axis) {
        if (has_walls_across(tile.walls, axis)) Mirror(tile, axis).add_images();
    }
    tile.walls = Walls::kNone;
    tile.wall_edges.clear();
    tile.vertex_pairs.clear();
    tile.edge_pairs.clear();
    return tile;
}

}  // namespace pcvt
