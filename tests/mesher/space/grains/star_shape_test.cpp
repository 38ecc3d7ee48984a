#include "mesher/space/grains/star_shape.hpp"

#include <gtest/gtest.h>

#include "mesher/space/grains/cell_filling.hpp"
#include "mesher/space/grains/cell_sizes.hpp"
#include "mesher/space/grains/grain_surface.hpp"
#include "tests/support/polyhedra.hpp"
#include "tests/support/random_numbers.hpp"

namespace pcvt::space {
namespace {

CellTetrahedra random_cell(std::uint64_t seed) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const CellComplex complex =
        testing::complex_of({"random", cube, uniform_points(cube, 8, seed)});
    Workers workers(1);
    const std::vector<CellHull> hulls =
        cell_hulls(complex, grain_surface(complex, std::vector<double>(8, 0.2), workers));
    return *fill_cell(hulls[0], 0.2);
}

/// Laws (1) and (2), against the tetrahedra one by one.
TEST(StarShape, MeasuresAsTheTetrahedraOneByOne) {
    std::mt19937_64 random(1);
    const CellTetrahedra cell = random_cell(3);
    std::vector<int> star;
    for (int v = 0; v < cell.n_vertices(); ++v) {
        if (!cell.is_used(v)) continue;
        cell.find_star(v, star);
        StarShape shape;
        for (const int t : star) shape.add(cell, t, v);
        // Small enough to keep the tetrahedra, and large enough to turn some over.
        for (const double length : {0.0, 0.01, 0.3}) {
            const Vec3 way = length * Vec3(testing::random_number(random) - 0.5,
                                           testing::random_number(random) - 0.5,
                                           testing::random_number(random) - 0.5);
            double least = 1;
            double ratios = 0;
            for (const int t : star) {
                std::array<Vec3, 4> p;
                for (int k = 0; k < 4; ++k) {
                    const int w = cell.corners(t)[k];
                    p[k] = w == v ? Vec3(cell.point(v) + way) : cell.point(w);
                }
                least = std::min(least, smallest_sine(p[0], p[1], p[2], p[3]));
                ratios += volume_length_ratio(p[0], p[1], p[2], p[3]);
            }
            EXPECT_NEAR(shape.least_sine(way, -1), least, 1e-9);
            const StarShape::Measure all = shape.measure(way, -2);
            EXPECT_NEAR(all.least_sine, least, 1e-9);
            EXPECT_NEAR(all.sum_of_ratios, ratios, 1e-9);
            EXPECT_LE(shape.least_sine(way, 0.2), std::max(least, 0.2) + 1e-9);
        }
    }
}

TEST(StarShape, CentresAreTheMeansOfSpheresAndBarycentres) {
    const CellTetrahedra cell = random_cell(4);
    std::vector<int> star;
    for (int v = cell.n_hull(); v < cell.n_vertices(); ++v) {
        if (!cell.is_used(v)) continue;
        cell.find_star(v, star);
        StarShape shape;
        double volume = 0;
        Vec3 spheres = Vec3::Zero();
        Vec3 corners = Vec3::Zero();
        for (const int t : star) {
            shape.add(cell, t, v);
            const FourCorners& c = cell.corners(t);
            const double part =
                volume6(cell.point(c[0]), cell.point(c[1]), cell.point(c[2]), cell.point(c[3]));
            volume += part;
            spheres += part * cell.circumsphere_of(t).centre;
            corners += part * cell.barycentre(t);
        }
        const StarShape::Centres centres = shape.centres();
        EXPECT_LT((cell.point(v) + centres.of_spheres - spheres / volume).norm(), 1e-9);
        EXPECT_LT((cell.point(v) + centres.of_corners - corners / volume).norm(), 1e-9);
    }
}

/// A degenerate tetrahedron must not be better than any bound.
TEST(StarShape, AVertexOnAnotherOneIsNeverAGain) {
    const CellTetrahedra cell = random_cell(5);
    const int v = cell.n_hull();
    if (!cell.is_used(v)) GTEST_SKIP();
    std::vector<int> star;
    cell.find_star(v, star);
    StarShape shape;
    for (const int t : star) shape.add(cell, t, v);
    for (const int w : cell.corners(star[0])) {
        if (w == v) continue;
        EXPECT_LE(shape.least_sine(cell.point(w) - cell.point(v), -1), 0);
    }
}

/// Law (1) of cell_sizes().
TEST(CellSizes, FollowTheWidthAndNameFlatCells) {
    const Points one = Points::Constant(3, 1, 0.5);
    const CellComplex flat = testing::complex_of({"flat", Lattice::box(1, 1, 0.4), one});
    const CellSizes sizes = cell_sizes(flat, 0.35);
    EXPECT_NEAR(sizes.sizes[0], kSizeInWidth * 0.4, 1e-12);
    EXPECT_TRUE(sizes.flat.empty());
    const CellComplex plate = testing::complex_of({"plate", Lattice::box(1, 1, 0.1), one});
    const CellSizes thin = cell_sizes(plate, 0.2);
    EXPECT_EQ(thin.sizes[0], 0.2);
    ASSERT_EQ(thin.flat.size(), 1u);
    EXPECT_NEAR(thin.flat[0].angle, std::atan2(0.1, 0.2) * 180 / M_PI, 1e-9);
}

}  // namespace
}  // namespace pcvt::space
