#include "mesher/tile/wall_edges.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// In units of the side of the domain: some ulps of single precision.
constexpr double kOnWall = 0x1p-20;

}  // namespace

std::vector<WallEdge> edges_on_walls(const Tile& tile) {
    std::vector<WallEdge> edges;
    if (tile.walls == Walls::kNone || !is_upright(tile.lattice)) return edges;
    const int n = tile.n_vertices();
    const int n_own = n - static_cast<int>(tile.copies.size());
    const auto original = [&](int v) { return v < n_own ? v : tile.copies[v - n_own]; };
    const auto is_on = [&](int v, const WallSideRow& row) {
        const double off = tile.points[v][row.axis] - wall_line(row.side, tile.lattice);
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
                edges.push_back({row.side, original(v), original(to)});
            }
        }
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

}  // namespace pcvt
