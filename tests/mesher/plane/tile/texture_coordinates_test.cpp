#include "mesher/plane/tile/texture_coordinates.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt::plane {
namespace {

Tile cells(const Lattice& lattice, const Vec2& origin) {
    const PeriodicMesh mesh =
        cell_mesh(PeriodicDelaunay(Sites(lattice, uniform_points(lattice, 30, 5))));
    return make_tile(mesh, whole_outline(mesh, origin));
}

std::vector<Tile> textured_tiles() {
    std::vector<Tile> result;
    std::vector<Lattice> lattices = testing::awkward_lattices();
    lattices.emplace_back(Vec2(1, 0), Vec2(7, 1));
    for (const Lattice& lattice : lattices) {
        for (const Vec2& u : {Vec2(0, 0), Vec2(0.3, -2.7), Vec2(1000.25, -5e5)}) {
            result.push_back(cells(lattice, lattice.to_position(u)));
        }
    }
    return result;
}

// Law 1.
TEST(TextureCoordinates, PartnersDifferByExactlyTheOffset) {
    for (const Tile& tile : textured_tiles()) {
        const auto uv = texture_coordinates(tile);
        ASSERT_EQ(uv.size(), tile.points.size());
        for (const VertexPair& pair : tile.vertex_pairs) {
            EXPECT_EQ(uv[pair.w][0] - uv[pair.v][0], static_cast<float>(pair.offset.i));
            EXPECT_EQ(uv[pair.w][1] - uv[pair.v][1], static_cast<float>(pair.offset.j));
            EXPECT_EQ(double(uv[pair.w][0]) - uv[pair.v][0], pair.offset.i);
            EXPECT_EQ(uv[pair.v][1] + static_cast<float>(pair.offset.j), uv[pair.w][1]);
        }
    }
}

// Law 1, where rounding noise would break ties in two ways.
TEST(TextureCoordinates, PartnersBetweenTwoStepsAreRoundedAlike) {
    const Lattice lattice({1.0 / 3, 0.1}, {-0.2, 1.0 / 7});
    for (int k = 0; k < 200; ++k) {
        Tile tile = testing::grid_tile(lattice, 1, 1);
        const double odd = 2 * k + 1;
        for (Vec2& p : tile.points) p += lattice.to_position(std::ldexp(odd, -23) * Vec2(1, 1));
        const auto uv = texture_coordinates(tile);
        for (const VertexPair& pair : tile.vertex_pairs) {
            EXPECT_EQ(uv[pair.w][0] - uv[pair.v][0], static_cast<float>(pair.offset.i)) << k;
            EXPECT_EQ(uv[pair.w][1] - uv[pair.v][1], static_cast<float>(pair.offset.j)) << k;
        }
    }
}

// Law 2.
TEST(TextureCoordinates, TheOppositeDirectionIsExactAsWell) {
    for (const Tile& tile : textured_tiles()) {
        for (const auto& [u, v] : texture_coordinates(tile)) {
            EXPECT_EQ(double(1 - v), 1 - double(v));
        }
    }
}

// Law 3.
TEST(TextureCoordinates, GiveThePositionBackUpToWholePeriods) {
    for (const Tile& tile : textured_tiles()) {
        const auto uv = texture_coordinates(tile);
        for (int v = 0; v < tile.n_vertices(); ++v) {
            const Vec2 u = tile.lattice.to_lattice(tile.points[v]);
            const Vec2 moved = u - Vec2(uv[v][0], uv[v][1]);
            const Vec2 off = moved - moved.array().round().matrix();
            EXPECT_LT(off.cwiseAbs().maxCoeff(), std::ldexp(16, -23));
        }
    }
}

TEST(TextureCoordinates, TilesNearZeroKeepTheirLatticeCoordinates) {
    const Lattice lattice({2, 0}, {0.5, 1});
    const Tile tile = cells(lattice, {0, 0});
    const auto uv = texture_coordinates(tile);
    for (int v = 0; v < tile.n_vertices(); ++v) {
        const Vec2 p = lattice.to_position(Vec2(uv[v][0], uv[v][1]));
        EXPECT_LT((p - tile.points[v]).norm(), 1e-6);
    }
}

}  // namespace
}  // namespace pcvt::plane
