#include "mesher/plane/tile/tile_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

/// In units of the side of the domain: some ulps of single precision.
constexpr double kOnWall = 0x1p-20;

/// The side of a face from one vertex to the next.
struct Side {
    int from;
    int to;
    int face;

    std::array<int, 3> key() const { return {std::min(from, to), std::max(from, to), from}; }
    bool is_opposite(const Side& other) const { return from == other.to && to == other.from; }
};

bool is_before(const Side& side, const Side& other) { return side.key() < other.key(); }

/// Returns the sides of all faces; the two sides of an edge are adjacent.
std::vector<Side> sorted_sides(const Tile& tile) {
    std::vector<Side> sides;
    sides.reserve(tile.faces.corners.size());
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        int from = tile.faces[f].back();
        for (const int to : tile.faces[f]) sides.push_back({std::exchange(from, to), to, f});
    }
    cancellable_sort(sides.begin(), sides.end(), is_before);
    return sides;
}

/// Returns the face that runs from `from` to `to`.
int face_at(const std::vector<Side>& sides, int from, int to) {
    return std::lower_bound(sides.begin(), sides.end(), Side{from, to, 0}, is_before)->face;
}

}  // namespace

std::vector<TileEdge> tile_edges(const Tile& tile) {
    const std::vector<Side> sides = sorted_sides(tile);
    std::vector<TileEdge> edges;
    edges.reserve(sides.size() / 2 + 2 * tile.edge_pairs.size());
    for (std::size_t s = 0; s < sides.size(); ++s) {
        checkpoint_each(s);
        const auto [from, to, face] = sides[s];
        if (s + 1 < sides.size() && sides[s].is_opposite(sides[s + 1])) {
            edges.push_back(
                {.v = from, .w = to, .left = face, .right = sides[++s].face, .on_seam = false});
        }
    }
    // The faces at the two sides of a pair are neighbours.
    for (const EdgePair& pair : tile.edge_pairs) {
        const int left = face_at(sides, pair.v0, pair.v1);
        const int right = face_at(sides, pair.w1, pair.w0);
        edges.push_back(
            {.v = pair.v0, .w = pair.v1, .left = left, .right = right, .on_seam = true});
        edges.push_back(
            {.v = pair.w1, .w = pair.w0, .left = right, .right = left, .on_seam = true});
    }
    for (const WallEdge& wall : tile.wall_edges) {
        const int left = face_at(sides, wall.v0, wall.v1);
        edges.push_back({.v = wall.v0, .w = wall.v1, .left = left, .right = -1, .on_seam = false});
    }
    cancellable_sort(edges.begin(), edges.end(), [](const TileEdge& e, const TileEdge& f) {
        return std::minmax(e.v, e.w) < std::minmax(f.v, f.w);
    });
    return edges;
}

std::vector<WallEdge> edges_on_walls(const Tile& tile) {
    std::vector<WallEdge> edges;
    if (tile.walls == Walls::kNone || !is_upright(tile.lattice)) return edges;
    const int n = tile.n_vertices();
    const int n_own = n - static_cast<int>(tile.copies.size());
    const auto original = [&](int v) { return v < n_own ? v : tile.copies[v - n_own]; };
    const auto is_on = [&](int v, const WallSideRow& row) {
        const double off = tile.points[v][row.axis] - wall_line(row, tile.lattice);
        return std::abs(off) <= kOnWall * side_length(tile.lattice, row.axis);
    };
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        int from = tile.faces[f].back();
        for (const int to : tile.faces[f]) {
            const int v = std::exchange(from, to);
            if (v < 0 || to < 0 || v >= n || to >= n) continue;
            for (const WallSideRow& row : kWallSides) {
                if (!has_walls_across(tile.walls, row.axis)) continue;
                if (!is_on(v, row) || !is_on(to, row)) continue;
                edges.push_back({WallId::side(row.side), original(v), original(to)});
            }
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

}  // namespace pcvt::plane
