#include "tests/support/scrambled_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/support/grid_tile.hpp"

namespace pcvt::testing {
namespace {

plane::Tile jittered_grid(const plane::Lattice& lattice, std::mt19937& random) {
    const int columns = 1 + static_cast<int>(random() % 5);
    const int rows = 1 + static_cast<int>(random() % 5);
    plane::Tile tile = random() % 2 ? grid_tile(lattice, columns, rows)
                                    : triangle_grid_tile(lattice, columns, rows);
    std::uniform_real_distribution<double> jitter(-0.1, 0.1);
    for (plane::Vec2& p : tile.points) {
        p += lattice.to_position({jitter(random) / columns, jitter(random) / rows});
    }
    for (const plane::VertexPair& pair : tile.vertex_pairs) {
        tile.points[pair.w] = tile.points[pair.v] + lattice.translation(pair.offset);
    }
    return tile;
}

}  // namespace

std::vector<plane::Lattice> many_lattices() {
    return {plane::Lattice::rectangle(1, 1),
            plane::Lattice::rectangle(20, 1),
            plane::Lattice::rectangle(1, 20),
            plane::Lattice::rectangle(0.001, 0.002),
            plane::Lattice::rectangle(1e6, 1e6),
            plane::Lattice({1, 0}, {0.37, 0.81}),
            plane::Lattice({1, 0}, {7, 1}),
            plane::Lattice({0.5, 0.1}, {-0.2, 2}),
            plane::Lattice({0, 1}, {1, 0}),
            plane::Lattice({1, 0}, {0.5, std::sqrt(0.75)}),
            plane::Lattice({1.0 / 3, 1e-3}, {-333.3, 1.0 / 7}),
            plane::Lattice({1e-60, 0}, {0.3e-60, 1e-60})};
}

plane::Tile scrambled_grid(const plane::Lattice& lattice, std::mt19937& random) {
    const plane::Tile tile = jittered_grid(lattice, random);
    std::vector<int> name(tile.points.size());
    std::iota(name.begin(), name.end(), 0);
    std::shuffle(name.begin(), name.end(), random);
    plane::Tile result = tile;
    for (int v = 0; v < tile.n_vertices(); ++v) result.points[name[v]] = tile.points[v];
    for (plane::VertexPair& pair : result.vertex_pairs) {
        pair = {name[pair.v], name[pair.w], pair.offset};
        if (random() % 2) pair = {pair.w, pair.v, -pair.offset};
    }
    for (plane::EdgePair& e : result.edge_pairs) {
        e = {name[e.v0], name[e.v1], name[e.w0], name[e.w1], e.offset};
        if (random() % 2) e = e.reversed();
    }
    for (int& v : result.faces.corners) v = name[v];
    for (int f = 0; f < result.n_faces(); ++f) {
        const auto begin = result.faces.corners.begin() + result.faces.begin[f];
        std::rotate(begin, begin + random() % 3, begin + result.face_size(f));
    }
    return result;
}

}  // namespace pcvt::testing
