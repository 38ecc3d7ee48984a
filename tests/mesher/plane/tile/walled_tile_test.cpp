#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "mesher/plane/cvt/walled_cvt.hpp"
#include "mesher/plane/proof/generated_tile.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/plane/proof/validate_walls.hpp"
#include "mesher/plane/tile/build_tile.hpp"
#include "mesher/plane/tile/tile_valence.hpp"
#include "tests/support/case_count.hpp"

namespace pcvt::plane {
namespace {

WalledCvt walled(const Lattice& lattice, Walls walls, WallCells cells, int n, std::uint64_t seed,
                 int max_iterations) {
    CvtOptions options;
    options.run.max_iterations = max_iterations;
    options.run.tolerance = 1e-4;
    return compute_walled_cvt(lattice, walls, cells, uniform_points(lattice, n, seed), options);
}

/// Whether the vertices of wall edges lie on the walls exactly, and others between them.
void expect_on_walls(const Tile& tile) {
    for (const WallEdge& edge : tile.wall_edges) {
        const WallSideRow& wall = wall_side_row(edge.wall.side());
        EXPECT_EQ(tile.points[edge.v0][wall.axis], wall_line(wall, tile.lattice));
        EXPECT_EQ(tile.points[edge.v1][wall.axis], wall_line(wall, tile.lattice));
    }
}

/// The total length of the edges on each wall.
double length_on(const Tile& tile, WallSide side) {
    double length = 0;
    for (const WallEdge& edge : tile.wall_edges) {
        if (edge.wall.side() == side)
            length += (tile.points[edge.v1] - tile.points[edge.v0]).norm();
    }
    return length;
}

TEST(WalledTile, SlowRandomTilesBetweenWallsAreProved) {
    std::mt19937_64 random(7);
    const auto draw = [&](int from, int to) {
        return std::uniform_int_distribution<int>(from, to)(random);
    };
    for (int k = 0; k < testing::case_count("PCVT_WALLED_CASES", 300); ++k) {
        const auto walls = static_cast<Walls>(draw(1, 3));
        const int n = draw(1, 60);
        const double height = std::pow(10.0, 0.1 * draw(-8, 8));
        const Lattice lattice = Lattice::rectangle(1, height);
        const int max_iterations = draw(0, 1) * 30;
        const auto kind = draw(0, 1) == 0 ? MeshKind::kVoronoi : MeshKind::kGrains;
        const auto outline = draw(0, 1) == 0 ? Outline::kWhole : Outline::kBox;
        const double short_edges = 0.1 * draw(0, 2);
        const int copies = draw(1, 2);
        const double along = 0.1 * draw(-20, 20);
        const std::uint64_t seed = random();
        SCOPED_TRACE("case " + std::to_string(k) + ": n " + std::to_string(n) + ", walls " +
                     walls_row(walls).word + ", height " + std::to_string(height) + ", seed " +
                     std::to_string(seed) + ", kind " + mesh_kind_row(kind).word + ", outline " +
                     std::to_string(outline == Outline::kBox) + ", short edges " +
                     std::to_string(short_edges) + ", copies " + std::to_string(copies));
        const WalledCvt cvt = walled(lattice, walls, WallCells::kWhole, n, seed, max_iterations);
        TileOptions options{.kind = kind, .outline = outline, .short_edges = short_edges};
        options.walled = cvt.domain;
        if (walls == Walls::kX) {
            options.repeat.rows = copies;
            options.origin = {0, along};
        } else if (walls == Walls::kY) {
            options.repeat.columns = copies;
            options.origin = {along, 0};
        }
        try {
            const BuiltTile built = build_tile(cvt.torus.delaunay, options);
            const TileProof proof = verify_generated_tile(built.tile);
            EXPECT_EQ(built.figures.n_boundary_edges, proof.n_boundary_edges);
            EXPECT_EQ(proof.wall_edges, built.tile.wall_edges);
            expect_on_walls(built.tile);
            for (const WallSideRow& row : kWallSides) {
                const double wanted = has_walls_across(walls, row.axis)
                                          ? side_length(built.tile.lattice, 1 - row.axis)
                                          : 0;
                EXPECT_NEAR(length_on(built.tile, row.side), wanted, 1e-12 * (1 + height));
            }
        } catch (const LimitExceeded&) {
            // A piece of a cell too thin for grains.
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
        if (HasFailure() && k > 20000) break;
    }
}

TEST(WalledTile, HalfCellsMakeEveryKindOfMesh) {
    for (int seed = 0; seed < testing::case_count("PCVT_WALLED_CASES", 20); ++seed) {
        for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
            const int n = 12 + 3 * (seed % 20);
            SCOPED_TRACE("seed " + std::to_string(seed) + ", walls " + walls_row(walls).word);
            const Lattice lattice = Lattice::rectangle(2, 1);
            const WalledCvt cvt = walled(lattice, walls, WallCells::kHalf, n, seed, -1);
            EXPECT_GT(cvt.domain.n_on_walls, 0);
            for (const MeshKindRow& row : kMeshKinds) {
                for (const Outline outline : {Outline::kWhole, Outline::kBox}) {
                    if (outline == Outline::kBox && !row.box_outline) continue;
                    SCOPED_TRACE(row.word);
                    try {
                        const BuiltTile built = build_tile(
                            cvt.torus.delaunay,
                            {.kind = row.kind, .outline = outline, .walled = cvt.domain});
                        verify_generated_tile(built.tile);
                        expect_on_walls(built.tile);
                    } catch (const std::exception& error) {
                        ADD_FAILURE() << error.what();
                    }
                }
            }
        }
    }
}

TEST(WalledTile, WholeAndHalfCellsAreProvedToBeCentroidal) {
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        for (const WallCells cells : {WallCells::kWhole, WallCells::kHalf}) {
            for (const int n : {14, 60}) {
                const auto largest = [&](int max_iterations) {
                    const WalledCvt cvt =
                        walled(Lattice::rectangle(2, 1), walls, cells, n, 4, max_iterations);
                    const TileOptions options{.kind = MeshKind::kVoronoi, .walled = cvt.domain};
                    const Tile tile = build_tile(cvt.torus.delaunay, options).tile;
                    return prove_voronoi(tile, prove_tile(tile, Precision::kDouble), 1e-3);
                };
                EXPECT_LE(largest(-1), 1e-3);
                EXPECT_THROW(largest(2), NotATile);
            }
        }
    }
}

TEST(WalledTile, ValencesOnWallsCountTheMirrorImages) {
    for (const Walls walls : {Walls::kX, Walls::kY, Walls::kXY}) {
        const WalledCvt cvt = walled(Lattice::rectangle(2, 1), walls, WallCells::kHalf, 40, 3, -1);
        const Tile tile =
            build_tile(cvt.torus.delaunay, {.kind = MeshKind::kDelaunay, .walled = cvt.domain})
                .tile;
        const Tile torus = mirrored_tile(tile);
        const std::vector<int> valence = vertex_valences(tile);
        std::vector<int> wanted(torus.points.size(), 0);
        const TileProof proof = prove_cover(torus, Precision::kDouble);
        for (const int v : torus.faces.corners) ++wanted[v];
        for (const VertexPair& pair : proof.vertex_pairs) wanted[pair.v] += wanted[pair.w];
        for (const VertexPair& pair : proof.vertex_pairs) wanted[pair.w] = wanted[pair.v];
        for (int v = 0; v < tile.n_vertices(); ++v) EXPECT_EQ(valence[v], wanted[v]);
    }
}

TEST(WalledTile, MirrorImagesOfTheFirstFaceOfASiteAreTheFirst) {
    const WalledCvt cvt = walled(Lattice::rectangle(2, 1), Walls::kX, WallCells::kWhole, 30, 3, 30);
    for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kGrains}) {
        const Tile tile = build_tile(cvt.torus.delaunay,
                                     {.kind = kind, .outline = Outline::kBox, .walled = cvt.domain})
                              .tile;
        const Tile torus = mirrored_tile(tile);
        const auto first = [](const Tile& of, SiteId site) {
            return std::find(of.face_site.begin(), of.face_site.end(), site) - of.face_site.begin();
        };
        for (SiteId site = 0; site < 30; ++site) {
            EXPECT_EQ(first(torus, site + 30), first(torus, site) + tile.n_faces());
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
