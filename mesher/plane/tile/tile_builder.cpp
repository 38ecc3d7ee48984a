#include "mesher/plane/tile/tile_builder.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "mesher/base/bucket_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"

namespace pcvt::plane {
namespace {

/// One vertex of a tile: an image of an orbit.
struct Placed {
    int orbit;
    Offset offset;
    friend bool operator==(const Placed&, const Placed&) = default;
};

class TileBuilder {
   public:
    TileBuilder(const PeriodicMesh& periodic, const std::vector<Offset>& placement,
                const WalledDomain* walled)
        : periodic_(periodic),
          placement_(placement),
          walled_(walled),
          tile_{.lattice = periodic.lattice, .kind = periodic.kind} {
        if (static_cast<int>(placement.size()) != periodic.n_faces()) {
            throw InternalError("the placement of the faces lacks some, or has too many");
        }
        if (walled != nullptr) tile_.walls = walled->walls;
    }

    Tile build() {
        tile_.faces.begin = periodic_.face_begin;
        number_vertices();
        position_vertices();
        take_sites();
        pair_edges();
        return std::move(tile_);
    }

   private:
    Placed placed(int corner) const {
        return {periodic_.corner_vertex[corner],
                placement_[periodic_.corner_face[corner]] + periodic_.corner_offset[corner]};
    }

    /// For each corner the first one that lies at its vertex.
    std::vector<int> first_corners() const {
        std::vector<int> order(periodic_.corner_vertex.size());
        std::iota(order.begin(), order.end(), 0);
        bucket_sort(
            order, periodic_.n_vertices(), [&](int c) { return periodic_.corner_vertex[c]; },
            [&](int c, int d) {
                return std::tuple(placed(c).offset, c) < std::tuple(placed(d).offset, d);
            });
        std::vector<int> first(order.size());
        for (std::size_t k = 0; k < order.size(); ++k) {
            checkpoint_each(k);
            const bool same = k > 0 && placed(order[k]) == placed(order[k - 1]);
            first[order[k]] = same ? first[order[k - 1]] : order[k];
        }
        return first;
    }

    void number_vertices() {
        tile_.faces.corners = first_corners();
        std::vector<int>& corners = tile_.faces.corners;
        for (int c = 0; c < periodic_.n_corners(); ++c) {
            checkpoint_each(c);
            if (corners[c] == c) {
                corners[c] = static_cast<int>(vertices_.size());
                vertices_.push_back(placed(c));
            } else {
                corners[c] = corners[corners[c]];
            }
        }
    }

    void position_vertices() {
        std::vector<int> representative(periodic_.vertices.size(), -1);
        tile_.points.reserve(vertices_.size());
        for (int v = 0; v < static_cast<int>(vertices_.size()); ++v) {
            checkpoint_each(v);
            const auto [orbit, offset] = vertices_[v];
            tile_.points.push_back(periodic_.vertices[orbit] + tile_.lattice.translation(offset));
            int& first = representative[orbit];
            if (first < 0) {
                first = v;
            } else {
                tile_.vertex_pairs.push_back({first, v, offset - vertices_[first].offset});
            }
        }
    }

    void take_sites() {
        if (faces_have_sites(tile_.kind)) {
            tile_.face_site = periodic_.site;
            tile_.whole_sides = periodic_.whole_sides;
        } else {
            tile_.vertex_site.reserve(vertices_.size());
            for (const Placed& v : vertices_) {
                tile_.vertex_site.push_back(periodic_.site[v.orbit]);
            }
        }
        tile_.site_points.reserve(periodic_.site_points.size());
        for (std::size_t f = 0; f < periodic_.site_points.size(); ++f) {
            tile_.site_points.push_back(periodic_.site_points[f] +
                                        tile_.lattice.translation(placement_[f]));
        }
    }

    /// The edge of a corner and the edge across it coincide unless their faces are placed with
    /// different offsets.
    void pair_edges() {
        const std::vector<int>& vertex = tile_.faces.corners;
        for (int c = 0; c < periodic_.n_corners(); ++c) {
            checkpoint_each(c);
            const int across = periodic_.opposite[c];
            const int v0 = vertex[c];
            const int v1 = vertex[periodic_.next(c)];
            if (across < 0) {
                tile_.wall_edges.push_back(
                    {WallId::side(wall_side_of(periodic_, c, *walled_).side), v0, v1});
                continue;
            }
            const int w0 = vertex[periodic_.next(across)];
            const int w1 = vertex[across];
            const Offset offset = vertices_[w1].offset - vertices_[v1].offset;
            // Take the side of the pair whose translation is positive: the other one has the
            // negative.
            if (offset > Offset{})
                tile_.edge_pairs.push_back(
                    {.v0 = v0, .v1 = v1, .w0 = w0, .w1 = w1, .offset = offset});
        }
        std::sort(tile_.wall_edges.begin(), tile_.wall_edges.end());
    }

    const PeriodicMesh& periodic_;
    const std::vector<Offset>& placement_;
    /// nullptr: no walls.
    const WalledDomain* walled_;
    Tile tile_;
    /// By the number of each vertex in the tile.
    std::vector<Placed> vertices_;
};

}  // namespace

Tile make_tile(const PeriodicMesh& periodic, const std::vector<Offset>& placement) {
    return TileBuilder(periodic, placement, nullptr).build();
}

Tile make_walled_tile(const PeriodicMesh& between, const std::vector<Offset>& placement,
                      const WalledDomain& domain) {
    return TileBuilder(between, placement, &domain).build();
}

}  // namespace pcvt::plane
