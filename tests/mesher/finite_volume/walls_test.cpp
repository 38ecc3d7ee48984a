#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "mesher/finite_volume/cell_flow.hpp"
#include "mesher/finite_volume/extruded_base.hpp"
#include "mesher/finite_volume/extruded_mesh.hpp"
#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/plane/tile/tile_edges.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/walled_tiles.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using testing::walled_tile;

const double kPi = std::numbers::pi;

struct WalledKind {
    plane::MeshKind kind;
    WallCells cells;
};
const WalledKind kWalledKinds[] = {{plane::MeshKind::kVoronoi, WallCells::kWhole},
                                   {plane::MeshKind::kVoronoi, WallCells::kHalf},
                                   {plane::MeshKind::kDelaunay, WallCells::kHalf},
                                   {plane::MeshKind::kGrains, WallCells::kWhole},
                                   {plane::MeshKind::kGrains, WallCells::kHalf}};

plane::Tile channel(Walls walls = Walls::kY) {
    return walled_tile(walls, WallCells::kWhole, 12, {});
}

TEST(ExtrudedWalls, ThePatchesAreTheEdgesOnWalls) {
    std::mt19937_64 random(2);
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        for (const auto& [kind, cells] : kWalledKinds) {
            const int n = static_cast<int>(6 + random() % 30);
            SCOPED_TRACE(std::string(walls_row(walls).word) + ' ' + mesh_kind_row(kind).word + ' ' +
                         std::to_string(n));
            plane::Tile tile = walled_tile(walls, cells, n, {.kind = kind});
            plane::Tile back = extruded_base(extruded_mesh(tile), tile.lattice, kind);
            EXPECT_EQ(back.points, tile.points);
            EXPECT_EQ(back.walls, walls);
            EXPECT_EQ(back.wall_edges, tile.wall_edges);
            std::sort(back.edge_pairs.begin(), back.edge_pairs.end());
            std::sort(tile.edge_pairs.begin(), tile.edge_pairs.end());
            EXPECT_EQ(back.edge_pairs, tile.edge_pairs);
            const plane::TileProof proof = prove_tile(back, plane::Precision::kDouble);
            compare_edge_pairs(back, proof);
            compare_wall_edges(back, proof);
        }
    }
}

TEST(ExtrudedWalls, ThePatchesFollowTheSeamInTheOrderOfTheWalls) {
    std::vector<std::string> names;
    for (const FiniteVolumePatch& patch : extruded_mesh(channel(Walls::kXY)).patches) {
        names.push_back(patch.name);
    }
    EXPECT_THAT(names, ::testing::ElementsAre("wall_left", "wall_right", "wall_bottom", "wall_top",
                                              "back", "front"));
    const FiniteVolumeMesh extruded = extruded_mesh(channel());
    const std::size_t n = extruded.patches.size();
    EXPECT_EQ(extruded.patches[n - 5].partner, static_cast<int>(n) - 6);
    EXPECT_EQ(extruded.patches[n - 4].name, "wall_bottom");
    EXPECT_EQ(extruded.patches[n - 3].name, "wall_top");
    EXPECT_EQ(extruded.patches[n - 3].kind, PatchKind::kWall);
}

TEST(ExtrudedWalls, TheThicknessIsTheGivenOne) {
    const plane::Tile tile = channel();
    EXPECT_EQ(extruded_mesh(tile, 0.125).points.back().z(), 0.125);
    EXPECT_EQ(extruded_mesh(tile).points.back().z(), std::sqrt(2.0 / 12));
}

/// Returns the message of extruded_base, or of the proof of its edges on walls, for the extruded
/// channel after `damage`, which gets the patch of the lower wall and the one of the upper wall.
template <class Damage>
std::string wall_fault_after(Damage damage,
                             const plane::Lattice& lattice = plane::Lattice::rectangle(2, 1)) {
    FiniteVolumeMesh extruded = extruded_mesh(channel());
    const std::size_t n = extruded.patches.size();
    damage(extruded.patches[n - 4], extruded.patches[n - 3]);
    try {
        const plane::Tile tile = extruded_base(extruded, lattice, plane::MeshKind::kVoronoi);
        compare_wall_edges(tile, prove_tile(tile, plane::Precision::kDouble));
    } catch (const NotATile& fault) {
        return fault.what();
    }
    return "";
}

TEST(ExtrudedWalls, FalseWallsAreRefused) {
    using Patch = FiniteVolumePatch;
    const auto no_damage = [](Patch&, Patch&) {};
    EXPECT_EQ(wall_fault_after(no_damage), "");
    const char* const law = "law (4) of extruded meshes, walls";
    EXPECT_THAT(wall_fault_after([](Patch& low, Patch&) { low.name = "wall_top"; }),
                HasSubstr("lies off its patch wall_top"));
    EXPECT_THAT(wall_fault_after([](Patch& low, Patch& high) { std::swap(low.name, high.name); }),
                HasSubstr("lies off its patch wall_top"));
    EXPECT_THAT(wall_fault_after([](Patch& low, Patch& high) {
                    low.name = "wall_left";
                    high.name = "wall_right";
                }),
                HasSubstr(law));
    EXPECT_THAT(wall_fault_after([](Patch& low, Patch& high) {
                    ++low.n_faces;
                    ++high.first_face;
                    --high.n_faces;
                }),
                HasSubstr("lies off its patch wall_bottom"));
    EXPECT_THAT(wall_fault_after([](Patch& low, Patch&) { low.partner = 0; }), HasSubstr(law));
    EXPECT_THAT(wall_fault_after([](Patch& low, Patch&) { low.kind = PatchKind::kEmpty; }),
                HasSubstr("a cell is open"));
    EXPECT_THAT(wall_fault_after(no_damage, plane::Lattice({2, 0}, {0.5, 1})), HasSubstr("law ("));
}

TEST(ExtrudedWalls, AWallOnAnInnerLineIsNoWall) {
    // The upper wall lies at y = 1, not at the height.
    const FiniteVolumeMesh extruded =
        extruded_mesh(walled_tile(Walls::kXY, WallCells::kWhole, 12, {}));
    EXPECT_THROW(
        extruded_base(extruded, plane::Lattice::rectangle(2, 1.5), plane::MeshKind::kVoronoi),
        NotATile);
}

TEST(WalledFlow, VanishesOnWallsAndHasNoDivergence) {
    const plane::Lattice lattice = plane::Lattice::rectangle(3, 2);
    const double h = 1e-4;
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        const DecayingFlow flow(lattice, walls);
        double largest = 0;
        for (int k = 0; k <= 60 * 60; ++k) {
            const plane::Vec2 p(k % 61 / 20.0, k / 61 / 30.0);
            largest = std::max(largest, flow.velocity(p).norm());
            for (const WallSideRow& row : kWallSides) {
                if (!has_walls_across(walls, row.axis)) continue;
                plane::Vec2 on_wall = p;
                on_wall[row.axis] = wall_line(row, lattice);
                EXPECT_LT(flow.velocity(on_wall).norm(), 1e-15);
            }
            const double divergence =
                (flow.velocity(p + plane::Vec2(h, 0)) - flow.velocity(p - plane::Vec2(h, 0))).x() +
                (flow.velocity(p + plane::Vec2(0, h)) - flow.velocity(p - plane::Vec2(0, h))).y();
            EXPECT_LT(std::abs(divergence / (2 * h)), 1e-6);
            const plane::Vec2 gradient(
                flow.stream(p + plane::Vec2(h, 0)) - flow.stream(p - plane::Vec2(h, 0)),
                flow.stream(p + plane::Vec2(0, h)) - flow.stream(p - plane::Vec2(0, h)));
            EXPECT_LT(
                (plane::Vec2(gradient.y(), -gradient.x()) / (2 * h) - flow.velocity(p)).norm(),
                1e-6);
        }
        EXPECT_LE(largest, 1 + 1e-14);
        EXPECT_GT(largest, 0.995);
    }
}

TEST(WalledFlow, BetweenTwoWallsItIsASine) {
    const DecayingFlow along(plane::Lattice::rectangle(3, 2), Walls::kY);
    EXPECT_NEAR((along.velocity({0.7, 0.4}) - plane::Vec2(std::sin(kPi * 0.2), 0)).norm(), 0,
                1e-15);
    EXPECT_DOUBLE_EQ(along.rate(), kPi * kPi / 4);
    EXPECT_DOUBLE_EQ(along.mean_square_speed(), 0.5);
    const DecayingFlow up(plane::Lattice::rectangle(3, 2), Walls::kX);
    EXPECT_NEAR((up.velocity({0.6, 0.4}) - plane::Vec2(0, std::sin(kPi * 0.2))).norm(), 0, 1e-15);
    EXPECT_DOUBLE_EQ(up.rate(), kPi * kPi / 9);
}

TEST(WalledFlow, InABoxTheRateIsThatOfTheFirstLossOfEnergy) {
    const DecayingFlow flow(plane::Lattice::rectangle(3, 2), Walls::kXY);
    EXPECT_FALSE(flow.keeps_shape());
    const int n = 200;
    const double h = 1e-4;
    double speed = 0;
    double curl = 0;
    for (int k = 0; k < n * n; ++k) {
        const plane::Vec2 p(3 * (k % n + 0.5) / n, 2 * (k / n + 0.5) / n);
        speed += flow.velocity(p).squaredNorm() / (n * n);
        const double w =
            (flow.velocity(p + plane::Vec2(h, 0)) - flow.velocity(p - plane::Vec2(h, 0))).y() -
            (flow.velocity(p + plane::Vec2(0, h)) - flow.velocity(p - plane::Vec2(0, h))).x();
        curl += w * w / (4 * h * h) / (n * n);
    }
    EXPECT_NEAR(speed, flow.mean_square_speed(), 1e-9);
    EXPECT_NEAR(curl / speed, flow.rate(), 1e-5);
}

TEST(WalledFlow, OnCellsItKeepsItsMeanAndRests) {
    const plane::Tile tile = walled_tile(Walls::kY, WallCells::kWhole, 300, {});
    const CellFlow cells =
        cell_flow(DecayingFlow(tile.lattice, tile.walls), tile, extruded_mesh(tile));
    EXPECT_FALSE(cells.at_rest);
    double flux = 0;
    for (int f = 0; f < tile.n_faces(); ++f) {
        plane::Polygon polygon;
        for (const int v : tile.faces[f]) polygon.push_back(tile.points[v]);
        flux += plane::polygon_area(polygon) * cells.velocity[f].x();
    }
    EXPECT_NEAR(flux / tile.lattice.area(), 2 / kPi, 5e-3);
    // One cell across the channel cannot represent the sine.
    const plane::Tile coarse = walled_tile(Walls::kY, WallCells::kWhole, 1, {});
    EXPECT_TRUE(cell_flow(DecayingFlow(coarse.lattice, coarse.walls), coarse, extruded_mesh(coarse))
                    .at_rest);
}

TEST(WalledFlow, WallsDampIt) {
    // Both rows of squares have one speed; only the walls take up momentum.
    plane::Tile tile = testing::grid_tile(plane::Lattice::rectangle(2, 1), 4, 2);
    std::erase_if(tile.edge_pairs, [](const plane::EdgePair& pair) { return pair.offset.j != 0; });
    tile.walls = Walls::kY;
    tile.wall_edges = edges_on_walls(tile);
    EXPECT_EQ(tile.wall_edges.size(), 8);
    const DecayingFlow flow(tile.lattice, tile.walls);
    EXPECT_FALSE(cell_flow(flow, tile, extruded_mesh(tile)).at_rest);
}

TEST(WalledFlow, OnSmallCellsOfAnyKindItMoves) {
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        for (const auto& [kind, wall_cells] : kWalledKinds) {
            const plane::Tile tile = walled_tile(walls, wall_cells, 150, {.kind = kind});
            const DecayingFlow flow(tile.lattice, walls);
            EXPECT_FALSE(cell_flow(flow, tile, extruded_mesh(tile)).at_rest)
                << walls_row(walls).word << ' ' << mesh_kind_row(kind).word;
        }
    }
}

}  // namespace
}  // namespace pcvt
