#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "mesher/plane/geometry/polygon.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "tests/support/grid_tile.hpp"
#include "tests/support/polygon_tile.hpp"

namespace pcvt::plane {
namespace {

using ::testing::AllOf;
using testing::float_fans;
using testing::grid_tile;
using ::testing::HasSubstr;
using testing::honeycomb_tile;
using ::testing::ThrowsMessage;
using testing::triangle_grid_tile;

double largest_distance(const Tile& tile, double tolerance,
                        Precision precision = Precision::kDouble) {
    return prove_voronoi(tile, prove_tile(tile, precision), tolerance);
}

/// Moves each orbit of vertices by a common vector of up to `amount` per coordinate.
Tile jittered(Tile tile, double amount, std::mt19937& random) {
    std::uniform_real_distribution<double> jitter(-amount, amount);
    const TileProof proof = prove_tile(tile, Precision::kDouble);
    for (Vec2& p : tile.points) p += Vec2(jitter(random), jitter(random));
    for (const VertexPair& pair : proof.vertex_pairs) {
        tile.points[pair.w] = tile.points[pair.v] + tile.lattice.translation(pair.offset);
    }
    return tile;
}

TEST(ProveVoronoi, HoneycombsAndRectanglesAreCentroidal) {
    for (const auto& [columns, rows] : {std::pair(1, 1), {1, 2}, {2, 1}, {5, 4}}) {
        EXPECT_LT(largest_distance(honeycomb_tile(columns, rows), 1e-12), 1e-14);
        EXPECT_LT(largest_distance(grid_tile(Lattice::rectangle(3, 1), columns, rows), 1e-12),
                  1e-14);
    }
}

TEST(ProveVoronoi, ObliqueParallelogramsAreNotVoronoiCells) {
    const Tile tile = grid_tile(Lattice({1, 0}, {0.37, 0.81}), 3, 2);
    EXPECT_THAT([&] { largest_distance(tile, 1e-6); },
                ThrowsMessage<NotATile>(AllOf(HasSubstr("law of Voronoi"), HasSubstr("face 0"),
                                              HasSubstr("off the bisector"))));
}

TEST(ProveVoronoi, CellsMustBeConvex) {
    Tile tile = grid_tile(Lattice::rectangle(3, 3), 3, 3);
    tile.points[5] = {0.4, 0.4};
    EXPECT_THAT(
        [&] { largest_distance(tile, 1e-3); },
        ThrowsMessage<NotATile>(AllOf(HasSubstr("face 0 is not convex"), HasSubstr("0.141 h"))));
}

TEST(ProveVoronoi, DistanceFollowsTheVertexAndIsMeasuredInH) {
    for (const double scale : {1e-4, 1.0, 1e5}) {
        Tile tile = grid_tile(Lattice::rectangle(3 * scale, 3 * scale), 3, 3);
        tile.points[5] += Vec2(1e-6, 1e-6) * scale;
        const double distance = largest_distance(tile, 1e-5);
        EXPECT_GT(distance, 0.5e-6);
        EXPECT_LT(distance, 2e-6);
        EXPECT_THROW(largest_distance(tile, 0.99 * distance), NotATile);
        EXPECT_EQ(largest_distance(tile, 1.01 * distance), distance);
    }
}

struct Centroid {
    Vec2 position;
    int face;
};

std::vector<Centroid> images_of_centroids(const Tile& tile, int reach) {
    std::vector<Centroid> images;
    for (int f = 0; f < tile.n_faces(); ++f) {
        Polygon polygon;
        for (const int v : tile.faces[f]) {
            polygon.push_back(tile.points[v]);
        }
        for (int i = -reach; i <= reach; ++i) {
            for (int j = -reach; j <= reach; ++j) {
                images.push_back({polygon_centroid(polygon) + tile.lattice.translation({i, j}), f});
            }
        }
    }
    return images;
}

/// Returns the largest amount by which a corner of a cell is nearer to some image of a centroid
/// than to its own centroid.
double brute_force_excess(const Tile& tile) {
    const std::vector<Centroid> images = images_of_centroids(tile, 3);
    const std::vector<Centroid> own = images_of_centroids(tile, 0);
    double excess = 0;
    for (int f = 0; f < tile.n_faces(); ++f) {
        for (int c = tile.faces.begin[f]; c < tile.faces.begin[f + 1]; ++c) {
            const Vec2& corner = tile.points[tile.faces.corners[c]];
            for (const Centroid& image : images) {
                excess = std::max(
                    excess, (corner - own[f].position).norm() - (corner - image.position).norm());
            }
        }
    }
    return excess;
}

TEST(ProveVoronoi, AgreesWithAllImagesOfAllCentroids) {
    std::mt19937 random(3);
    for (int round = 0; round < 60; ++round) {
        const double amount = std::pow(10.0, -1 - round % 8);
        const Tile tile = jittered(honeycomb_tile(1 + round % 3, 1 + round % 2), amount, random);
        const double h = std::sqrt(tile.lattice.area() / tile.n_faces());
        const double excess = brute_force_excess(tile) / h;
        const double distance = largest_distance(tile, 1);
        // A corner with the excess e lies between e / 2 and e off the bisector.
        EXPECT_LE(excess, 2 * distance);
        EXPECT_GE(excess, 0.1 * distance);
        EXPECT_THROW(largest_distance(tile, excess / 3), NotATile);
    }
}

TEST(ProveVoronoi, FansOfTrianglesAreJoinedToCells) {
    const Tile hexagons = float_fans(honeycomb_tile(4, 3));
    EXPECT_LT(largest_distance(hexagons, 1e-5, Precision::kSingle), 1e-6);
    Tile strangers = hexagons;
    for (int f = 0; f < strangers.n_faces(); ++f) strangers.face_site[f] = f;
    EXPECT_THROW(largest_distance(strangers, 1e-5, Precision::kSingle), NotATile);
}

TEST(ProveVoronoi, AdjacentCopiesOfOneSiteAreNotJoined) {
    // All cells have one site, as in a repeated tile of one site.
    Tile tile = honeycomb_tile(3, 2);
    for (SiteId& site : tile.face_site) site = 0;
    EXPECT_LT(largest_distance(tile, 1e-12), 1e-14);
    EXPECT_LT(largest_distance(float_fans(tile), 1e-5, Precision::kSingle), 1e-6);
    // The last corner of the second square is the second corner of the third one.
    Tile squares = grid_tile(Lattice::rectangle(1, 1), 2, 2);
    for (SiteId& site : squares.face_site) site = 0;
    EXPECT_LT(largest_distance(float_fans(squares), 1e-5, Precision::kSingle), 1e-6);
}

TEST(ProveDelaunay, GridsOfAcuteAndRightTrianglesAreDelaunay) {
    for (const auto& [columns, rows] : {std::pair(1, 1), {1, 2}, {4, 3}}) {
        const Lattice acute({1, 0}, {-0.4, 0.9});
        EXPECT_EQ(largest_distance(triangle_grid_tile(acute, columns, columns), 1e-12), 0);
        const Lattice square = Lattice::rectangle(columns, rows);
        EXPECT_NEAR(largest_distance(triangle_grid_tile(square, columns, rows), 1e-12), 0, 1e-14);
    }
}

TEST(ProveDelaunay, WrongDiagonalIsRefusedWithItsDepth) {
    const Tile tile = triangle_grid_tile(Lattice({1, 0}, {0.4, 0.9}), 3, 3);
    EXPECT_THAT([&] { largest_distance(tile, 1e-6); },
                ThrowsMessage<NotATile>(AllOf(HasSubstr("law of Delaunay"), HasSubstr("face 0"),
                                              HasSubstr("inside the circumcircle"))));
}

TEST(ProveDelaunay, DepthIsTheDepthOfTheCornerInTheCircle) {
    // For sides (1, 0) and (s, 1) the power of the corner is 2 s; radius and distance are sqrt(1/2)
    // + O(s).
    for (const double shear : {1e-3, 1e-6}) {
        const Tile tile = triangle_grid_tile(Lattice({1, 0}, {shear, 1}), 2, 2);
        EXPECT_NEAR(largest_distance(tile, 1), std::sqrt(2) * shear, 2 * shear * shear);
    }
}

TEST(ProveDelaunay, CellsOfMoreThanThreeCornersAreRefused) {
    Tile tile = grid_tile(Lattice::rectangle(1, 1), 2, 2);
    tile.kind = MeshKind::kDelaunay;
    tile.face_site.clear();
    EXPECT_THAT([&] { largest_distance(tile, 1e-6); },
                ThrowsMessage<NotATile>(HasSubstr("face 0 has 4 corners, not 3")));
}

TEST(Voronoi, GrainsAreRefused) {
    const Tile tile = testing::grain_grid_tile(Lattice::rectangle(1, 1), 2, 2);
    const TileProof proof = prove_tile(tile, Precision::kDouble);
    EXPECT_THROW(prove_voronoi(tile, proof, 1), InvalidInput);
}

}  // namespace
}  // namespace pcvt::plane
