#include "tests/support/polygon_tile.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcvt::testing {
namespace {

int index_of(const std::vector<int>& permutation, int value) {
    return static_cast<int>(std::find(permutation.begin(), permutation.end(), value) -
                            permutation.begin());
}

plane::Vec2 rounded(const plane::Vec2& p) { return p.cast<float>().cast<double>(); }

}  // namespace

plane::Tile polygon_tile(const plane::Lattice& lattice,
                         const std::vector<plane::Polygon>& polygons) {
    plane::Tile tile{.lattice = lattice, .kind = plane::MeshKind::kVoronoi};
    for (const plane::Polygon& polygon : polygons) {
        for (const plane::Vec2& corner : polygon) {
            int v = 0;
            while (v < tile.n_vertices() && (tile.points[v] - corner).norm() > 1e-9) ++v;
            if (v == tile.n_vertices()) tile.points.push_back(corner);
            tile.faces.corners.push_back(v);
        }
        tile.face_site.push_back(tile.n_faces());
        tile.faces.close();
    }
    return tile;
}

plane::Tile honeycomb_tile(int columns, int rows) {
    const double half_width = std::sqrt(3.0) / 2;
    const plane::Vec2 across(2 * half_width, 0);
    const plane::Vec2 up(half_width, 1.5);
    std::vector<plane::Polygon> hexagons;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const plane::Vec2 centre = i * across + j * up;
            hexagons.push_back(
                {centre + plane::Vec2(half_width, -0.5), centre + plane::Vec2(half_width, 0.5),
                 centre + plane::Vec2(0, 1), centre + plane::Vec2(-half_width, 0.5),
                 centre + plane::Vec2(-half_width, -0.5), centre + plane::Vec2(0, -1)});
        }
    }
    return polygon_tile(plane::Lattice(columns * across, rows * up), hexagons);
}

plane::Tile square_tiled(const SquareTiled& surface) {
    const auto bulge = [](int s) { return 0.02 * (s + 1); };
    std::vector<plane::Polygon> squares;
    for (int s = 0; s < static_cast<int>(surface.at.size()); ++s) {
        const int left = index_of(surface.right, s);
        const int below = index_of(surface.above, s);
        const plane::Polygon corners = {{0, 0}, {0.5, bulge(below)}, {1, 0}, {1 + bulge(s), 0.5},
                                        {1, 1}, {0.5, 1 + bulge(s)}, {0, 1}, {bulge(left), 0.5}};
        squares.emplace_back();
        for (const plane::Vec2& corner : corners) squares.back().push_back(surface.at[s] + corner);
    }
    return polygon_tile(plane::Lattice::rectangle(1, 1), squares);
}

plane::Tile float_fans(const plane::Tile& tile) {
    plane::Tile fans{.lattice = tile.lattice, .kind = tile.kind};
    std::vector<int> first_copy(tile.points.size(), -1);
    for (int f = 0; f < tile.n_faces(); ++f) {
        const int base = fans.n_vertices();
        for (int k = 0; k < tile.face_size(f); ++k) {
            const int v = tile.faces.corners[tile.faces.begin[f] + k];
            if (first_copy[v] < 0) first_copy[v] = fans.n_vertices();
            fans.points.push_back(rounded(tile.points[v]));
        }
        for (int k = 1; k + 1 < tile.face_size(f); ++k) {
            fans.faces.add(std::array{base, base + k, base + k + 1});
            if (!tile.face_site.empty()) fans.face_site.push_back(tile.face_site[f]);
        }
    }
    for (const plane::VertexPair& pair : tile.vertex_pairs) {
        fans.vertex_pairs.push_back({first_copy[pair.v], first_copy[pair.w], pair.offset});
    }
    return fans;
}

}  // namespace pcvt::testing
