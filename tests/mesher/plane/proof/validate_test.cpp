#include "mesher/plane/proof/validate.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "tests/support/example_lattices.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/polygon_tile.hpp"
#include "tests/support/scrambled_grid.hpp"

namespace pcvt::plane {
namespace {

using ::testing::AllOf;
using testing::grid_tile;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::kSquare;
using testing::many_lattices;
using testing::scrambled_grid;
using testing::square_tiled;
using testing::triangle_grid_tile;

/// Returns the message that refuses the tile; empty if the tile and its stored pairs are proved.
std::string refusal(const Tile& tile, Precision precision = Precision::kDouble) {
    try {
        const TileProof proof = prove_tile(tile, precision);
        if (!tile.vertex_pairs.empty()) compare_vertex_pairs(tile, proof);
        if (!tile.edge_pairs.empty()) compare_edge_pairs(tile, proof);
        return "";
    } catch (const NotATile& error) {
        return error.what();
    }
}

template <class Pair>
std::vector<Pair> sorted(std::vector<Pair> pairs) {
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

void expect_proved(const Tile& tile, int n_vertices, int n_orbits) {
    const TileProof proof = prove_tile(tile, Precision::kDouble);
    EXPECT_EQ(proof.n_vertices, n_vertices);
    EXPECT_EQ(proof.n_orbits, n_orbits);
    EXPECT_EQ(proof.n_faces, tile.n_faces());
    EXPECT_EQ(proof.n_merged, 0);
    EXPECT_EQ(proof.n_boundary_edges, 2 * static_cast<int>(tile.edge_pairs.size()));
    EXPECT_NEAR(proof.area / tile.lattice.area(), 1, 1e-9);
    EXPECT_TRUE(sorted(proof.vertex_pairs) == sorted(tile.vertex_pairs));
    EXPECT_TRUE(proof.edge_pairs == sorted(tile.edge_pairs));
    EXPECT_THAT(refusal(tile), IsEmpty());
}

/// A tile one corner of whose boundary lies off by `off` along x.
Tile tile_with_moved_corner(double off) {
    Tile tile = grid_tile(kSquare, 3, 2);
    tile.points.back().x() += off;
    return tile;
}

TEST(ProveTile, ATileOfAnotherProgramIsProvedWithinItsTolerance) {
    for (const double off : {1e-13, 1e-9, 1e-5}) {
        const Tile tile = tile_with_moved_corner(off);
        double mismatch = 0;
        try {
            prove_tile(tile, Precision::kDouble);
        } catch (const SeamMismatch& fault) {
            mismatch = fault.mismatch();
        }
        EXPECT_NEAR(mismatch, off, 1e-15);
        EXPECT_THROW(prove_tile(tile, Precision::kDouble, 0.9 * off), SeamMismatch);
        const TileProof proof = prove_tile(tile, Precision::kDouble, 1.1 * off);
        EXPECT_NEAR(proof.mismatch, off, 1e-15);
        EXPECT_EQ(proof.tolerance, 1.1 * off);
        EXPECT_EQ(proof.n_orbits, 6);
    }
    const TileProof exact = prove_tile(grid_tile(kSquare, 3, 2), Precision::kDouble, 1e-30);
    EXPECT_LE(exact.mismatch, exact.tolerance);
    EXPECT_GT(exact.tolerance, 1e-17);
}

TEST(ProveTile, AToleranceDoesNotMergeVertices) {
    EXPECT_THROW(prove_tile(tile_with_moved_corner(0), Precision::kDouble, 0.4), NotATile);
    Tile close = grid_tile(kSquare, 200, 2);
    EXPECT_NO_THROW(prove_tile(close, Precision::kDouble, 9e-4));
    close.points[1].x() = 8e-4;
    EXPECT_THAT([&] { prove_tile(close, Precision::kDouble, 9e-4); },
                ::testing::ThrowsMessage<NotATile>(HasSubstr("coincide")));
}

TEST(ProveTile, GridsOfAnyLatticeAreProvedWithTheirPairs) {
    for (const Lattice& lattice : many_lattices()) {
        for (const auto& [columns, rows] : {std::pair(1, 1), {1, 2}, {3, 1}, {2, 2}, {5, 3}}) {
            const int n_vertices = (columns + 1) * (rows + 1);
            expect_proved(grid_tile(lattice, columns, rows), n_vertices, columns * rows);
            expect_proved(triangle_grid_tile(lattice, columns, rows), n_vertices, columns * rows);
        }
    }
}

TEST(ProveTile, TileFarFromTheOriginIsProved) {
    for (const Lattice& lattice : many_lattices()) {
        Tile tile = grid_tile(lattice, 4, 3);
        const Vec2 far = lattice.to_position({1234.5678, -987.654});
        for (Vec2& p : tile.points) p += far;
        expect_proved(tile, 20, 12);
    }
}

TEST(ProveTile, ToleranceIsFourUlpsOfTheLargestCoordinate) {
    const Tile tile = grid_tile(Lattice::rectangle(3, 1), 2, 2);
    EXPECT_EQ(prove_tile(tile, Precision::kDouble).tolerance, 4 * 0x1p-51);
    EXPECT_EQ(prove_tile(tile, Precision::kSingle).tolerance, 4 * 0x1p-22);
}

TEST(ProveTile, OrderAndNumberingDoNotMatter) {
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        for (const Lattice& lattice : many_lattices()) {
            ASSERT_THAT(refusal(scrambled_grid(lattice, random)), IsEmpty()) << round;
        }
    }
}

// Law (1)

TEST(ProveTileFaces, NeedFiniteCoordinates) {
    Tile tile = grid_tile(kSquare, 2, 2);
    tile.points[3].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (1)"), HasSubstr("vertex 3")));
}

TEST(ProveTileFaces, NeedThreeDistinctCornersThatExist) {
    Tile tile = grid_tile(kSquare, 2, 2);
    tile.faces.corners[1] = tile.faces.corners[0];
    EXPECT_THAT(refusal(tile),
                AllOf(HasSubstr("law (1)"), HasSubstr("face 0"), HasSubstr("twice")));
    tile.faces.corners[1] = tile.faces.corners[3];
    EXPECT_THAT(refusal(tile),
                AllOf(HasSubstr("law (1)"), HasSubstr("meets vertex 3 more than once")));
    for (const int v : {-1, 9}) {
        tile.faces.corners[1] = v;
        EXPECT_THAT(refusal(tile), HasSubstr("names vertex " + std::to_string(v)));
    }
    tile = grid_tile(kSquare, 2, 2);
    tile.points.push_back({0.3, 0.3});
    EXPECT_THAT(refusal(tile), HasSubstr("vertex 9 belongs to no face"));
    tile.faces.begin = {0, 2, 8, 12, 16};
    EXPECT_THAT(refusal(tile), HasSubstr("face 0 has 2 corners"));
}

TEST(ProveTileFaces, DoNotMeetAVertexTwice) {
    // Face 1 of a pair of squares has a spike to a corner of face 0 and back.
    Tile tile = testing::polygon_tile(
        Lattice::rectangle(2, 1),
        {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 0}, {1, 1}}});
    EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (1)"), HasSubstr("face 1 meets vertex")));
}

TEST(ProveTileFaces, NeedPositiveArea) {
    // The vertex in the middle leaves face 3, but its edges remain matched.
    Tile tile = grid_tile(Lattice::rectangle(2, 2), 2, 2);
    tile.points[4] = {2.7, 2.7};
    EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (1)"), HasSubstr("face 3"), HasSubstr("-0.7")));
}

TEST(ProveTileFaces, DoNotCrossThemselves) {
    Tile tile = grid_tile(Lattice::rectangle(3, 3), 3, 3);
    tile.points[5] = {-0.5, 0.9};
    EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (1)"), HasSubstr("face 0 crosses itself")));
}

TEST(ProveTileFaces, VerticesOfOneTileMustNotCoincide) {
    Tile tile = grid_tile(kSquare, 2, 2);
    tile.points[4] = tile.points[0] + Vec2(1e-16, 0);
    EXPECT_THAT(refusal(tile), HasSubstr("vertices 0 and 4 coincide: they lie 1e-16 apart"));
}

TEST(ProveTileFaces, CoordinatesMustNotExceedThePeriodByFar) {
    Tile tile = grid_tile(kSquare, 2, 2);
    for (Vec2& p : tile.points) p.x() += 1e14;
    EXPECT_THAT(refusal(tile), HasSubstr("nearer to the origin"));
    tile = grid_tile(Lattice({1, 0}, {9e5, 1}), 2, 2);
    tile.points[4].y() += 1e9;
    EXPECT_THAT(refusal(tile), HasSubstr("periods away"));
}

// Law (2)

TEST(ProveTileSeam, VertexTenTolerancesOffIsRefusedWithTheAmount) {
    Tile tile = grid_tile(kSquare, 4, 4);
    const double moved = 10 * prove_tile(tile, Precision::kDouble).tolerance;
    tile.points[24].x() += moved;
    EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (2)"), HasSubstr("no reversed partner"),
                                     HasSubstr("8.88e-15")));
    tile.points[24].x() -= 0.95 * moved;
    EXPECT_THAT(refusal(tile), IsEmpty());
}

TEST(ProveTileSeam, LatticeScaledByOneInABillionIsRefused) {
    Tile tile = grid_tile(kSquare, 4, 4);
    tile.lattice = Lattice::rectangle(1 + 1e-9, 1 + 1e-9);
    EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (2)"), HasSubstr("off by 1e-09")));
}

void erase_face(Tile& tile, int f) {
    const auto begin = tile.faces.corners.begin() + tile.faces.begin[f];
    const int size = tile.face_size(f);
    tile.faces.corners.erase(begin, begin + size);
    tile.faces.begin.erase(tile.faces.begin.begin() + f);
    for (std::size_t g = f; g < tile.faces.begin.size(); ++g) tile.faces.begin[g] -= size;
}

TEST(ProveTileSeam, MissingFaceIsRefusedInsideAndAtTheBoundary) {
    for (const int f : {1, 5}) {
        Tile tile = grid_tile(kSquare, 4, 4);
        erase_face(tile, f);
        EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (2)"), HasSubstr("no reversed partner")));
    }
}

void append_face(Tile& tile, const std::vector<int>& corners) { tile.faces.add(corners); }

TEST(ProveTileSeam, DoubledFaceIsRefused) {
    Tile tile = grid_tile(kSquare, 4, 4);
    append_face(tile, {tile.faces.corners.begin() + 20, tile.faces.corners.begin() + 24});
    EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (2)"), HasSubstr("face 5"),
                                     HasSubstr("face 16"), HasSubstr("same direction")));
}

TEST(ProveTileSeam, FaceOnItsImageIsRefused) {
    // The fifth column coincides with an image of the first one.
    Tile tile = grid_tile(Lattice::rectangle(5, 4), 5, 4);
    tile.lattice = Lattice::rectangle(4, 4);
    EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (2)"), HasSubstr("images by (1, 0)")));
}

TEST(ProveTileSeam, TurnedFaceIsRefused) {
    Tile tile = grid_tile(kSquare, 4, 4);
    std::reverse(tile.faces.corners.begin() + 20, tile.faces.corners.begin() + 24);
    EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (2)"), HasSubstr("face 5")));
}

TEST(ProveTileSeam, SwappedCornersAreRefused) {
    Tile tile = grid_tile(kSquare, 4, 4);
    std::swap(tile.faces.corners[20], tile.faces.corners[21]);
    EXPECT_THAT(refusal(tile), HasSubstr("law (2)"));
}

TEST(ProveTileSeam, EdgeSplitOnOneSideOnlyIsRefused) {
    for (const double height : {0.0, 0.25, 1.0}) {
        Tile tile = grid_tile(kSquare, 1, 4);
        const auto corner = std::find_if(tile.faces.corners.begin(), tile.faces.corners.end(),
                                         [&](int v) { return tile.points[v] == Vec2(0, height); });
        tile.points.push_back({0.5, height});
        // Add a corner to the face whose last edge (height 1) or first edge is split.
        const auto face = (corner - tile.faces.corners.begin()) / 4;
        const int place = height == 1.0 ? 3 : 1;
        tile.faces.corners.insert(tile.faces.corners.begin() + 4 * face + place,
                                  tile.n_vertices() - 1);
        for (int f = static_cast<int>(face) + 1; f <= 4; ++f) ++tile.faces.begin[f];
        EXPECT_THAT(refusal(tile), HasSubstr("law (2)")) << height;
    }
}

TEST(ProveTileSeam, HoleWithoutPartnersIsRefused) {
    Tile tile = grid_tile(Lattice::rectangle(3, 3), 3, 3);
    erase_face(tile, 4);
    EXPECT_THAT(refusal(tile), HasSubstr("law (2)"));
}

// Laws (3) to (5): surfaces made of bulging squares satisfy laws (1) and (2).

TEST(ProveTileDisc, OneBulgingSquareIsProved) {
    EXPECT_THAT(refusal(square_tiled({{{0, 0}}, {0}, {0}})), IsEmpty());
}

TEST(ProveTileDisc, FacesThatMeetInAVertexOnlyArePinched) {
    EXPECT_THAT(refusal(square_tiled({{{0, 0}, {1, 1}}, {0, 1}, {0, 1}})),
                AllOf(HasSubstr("law (3)"), HasSubstr("pinched")));
}

TEST(ProveTileDisc, SeparateFacesAreRefused) {
    EXPECT_THAT(refusal(square_tiled({{{0, 0}, {3, 1}}, {1, 0}, {0, 1}})),
                AllOf(HasSubstr("law (3)"), HasSubstr("face 1 is not connected to face 0")));
}

TEST(ProveTileDisc, AnnulusIsRefused) {
    // Eight squares around a hole; opposite sides of the hole are glued.
    const testing::SquareTiled ring{
        {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {1, 2}, {2, 2}},
        {1, 2, 0, 4, 3, 6, 7, 5},
        {3, 6, 4, 5, 7, 0, 1, 2}};
    EXPECT_THAT(refusal(square_tiled(ring)), AllOf(HasSubstr("law (3)"), HasSubstr("hole")));
}

TEST(ProveTileTorus, SurfaceOfGenusTwoIsRefused) {
    EXPECT_THAT(refusal(square_tiled({{{0, 0}, {1, 0}, {0, 1}}, {1, 0, 2}, {2, 1, 0}})),
                AllOf(HasSubstr("law (4)"), HasSubstr("= -2, not 0")));
}

TEST(ProveTileAreas, DoubleCoverIsRefused) {
    // With cells 0.9 and 1.1 wide, no edge of one sheet lies on an edge of the other.
    const Tile tile = testing::polygon_tile(
        kSquare, {{{0, 0}, {0.9, 0}, {0.9, 1}, {0, 1}}, {{0.9, 0}, {2, 0}, {2, 1}, {0.9, 1}}});
    EXPECT_THAT(refusal(tile), AllOf(HasSubstr("law (5)"), HasSubstr("cover 2 of")));
}

// Single precision

TEST(ProveTileInSinglePrecision, FansWithSeparateVerticesAreProved) {
    for (const Lattice& lattice : many_lattices()) {
        if (lattice.area() < 1e-30 || lattice.area() < 1e-3 * lattice.b().squaredNorm()) continue;
        const Tile fans = testing::float_fans(grid_tile(lattice, 5, 3));
        const TileProof proof = prove_tile(fans, Precision::kSingle);
        EXPECT_EQ(proof.n_vertices, 24);
        EXPECT_EQ(proof.n_merged, 4 * 15 - 24);
        EXPECT_EQ(proof.n_faces, 30);
        EXPECT_EQ(proof.n_orbits, 15);
        EXPECT_EQ(proof.n_boundary_edges, 16);
        EXPECT_THAT(refusal(fans, Precision::kSingle), IsEmpty());
        EXPECT_THAT(refusal(fans, Precision::kDouble), HasSubstr("coincide"));
    }
}

TEST(ProveTileInSinglePrecision, EdgeThatShrinksToAPointIsDropped) {
    // A square with two opposite corners cut off, 1e-8 deep.
    const double e = 1e-8;
    Tile tile =
        testing::polygon_tile(Lattice({1 + e, e}, {e, 1 + e}),
                              {{{0, 0}, {1, 0}, {1 + e, e}, {1 + e, 1 + e}, {e, 1 + e}, {0, 1}}});
    EXPECT_EQ(prove_tile(tile, Precision::kDouble).n_orbits, 2);
    const TileProof proof = prove_tile(testing::float_fans(tile), Precision::kSingle);
    EXPECT_EQ(proof.n_orbits, 1);
    EXPECT_EQ(proof.n_merged, 2);
    EXPECT_EQ(proof.n_faces, 2);
    EXPECT_EQ(proof.n_boundary_edges, 4);
}

TEST(ProveTileInSinglePrecision, StatedCopiesAreChecked) {
    Tile fans = testing::float_fans(grid_tile(kSquare, 2, 2));
    fans.points.push_back(fans.points[5]);
    fans.copies = {5};
    EXPECT_THAT(refusal(fans, Precision::kSingle), IsEmpty());
    for (const int v : {4, -1, 16, 17}) {
        fans.copies = {v};
        EXPECT_THAT(refusal(fans, Precision::kSingle),
                    HasSubstr("vertex 16 is not a copy of vertex " + std::to_string(v)));
    }
    fans.copies.assign(20, 5);
    EXPECT_THAT(refusal(fans, Precision::kSingle), HasSubstr("is not a copy"));
}

TEST(ProveTileInSinglePrecision, CopyWithoutAFaceIsMerged) {
    Tile fans = testing::float_fans(grid_tile(kSquare, 2, 2));
    fans.points.push_back(fans.points[5]);
    EXPECT_EQ(prove_tile(fans, Precision::kSingle).n_merged, 8);
    fans.points.back().x() += 0.1;
    EXPECT_THAT(refusal(fans, Precision::kSingle), HasSubstr("vertex 16 belongs to no face"));
}

TEST(ProveTileInSinglePrecision, VertexTenTolerancesOffIsRefused) {
    Tile fans = testing::float_fans(grid_tile(kSquare, 4, 4));
    const double moved = 10 * prove_tile(fans, Precision::kSingle).tolerance;
    for (int v = 0; v < fans.n_vertices(); ++v) {
        Tile tile = fans;
        tile.points[v].y() += moved;
        EXPECT_THAT(refusal(tile, Precision::kSingle), HasSubstr("law (2)")) << v;
    }
}

// Random faults that break the topology of a tile are refused.

void break_at_random(Tile& tile, std::mt19937& random) {
    const int f = static_cast<int>(random() % tile.n_faces());
    const auto begin = tile.faces.corners.begin() + tile.faces.begin[f];
    const int size = tile.face_size(f);
    switch (random() % 6) {
        case 0:
            return erase_face(tile, f);
        case 1:
            return append_face(tile, {begin, begin + size});
        case 2:
            std::reverse(begin, begin + size);
            return;
        case 3:
            std::swap(begin[0], begin[1 + random() % (size - 1)]);
            return;
        case 4:
            tile.lattice = Lattice(tile.lattice.a() * (1 + 1e-9), tile.lattice.b());
            return;
        default:
            const auto& pair = tile.vertex_pairs[random() % tile.vertex_pairs.size()];
            tile.points[pair.w] += 1e-9 * (tile.lattice.a() + tile.lattice.b());
    }
}

TEST(ProveTile, RandomFaultsAreRefused) {
    std::mt19937 random(2);
    for (int round = 0; round < 3000; ++round) {
        const auto lattices = many_lattices();
        Tile tile = scrambled_grid(lattices[random() % lattices.size()], random);
        break_at_random(tile, random);
        ASSERT_THAT(refusal(tile), HasSubstr("law ")) << round;
    }
}

}  // namespace
}  // namespace pcvt::plane
