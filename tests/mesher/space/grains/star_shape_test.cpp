#include "mesher/space/grains/star_shape.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesher/space/grains/cell_filling.hpp"
#include "mesher/space/grains/cell_sizes.hpp"
#include "mesher/space/grains/grain_surface.hpp"
#include "tests/support/polyhedra.hpp"
#include "tests/support/random_numbers.hpp"

namespace pcvt::space {
namespace {

/// @param n_near  number of points of the hull, the first ones, that count as near to a sharp
///     feature.
CellTetrahedra random_cell(std::uint64_t seed, int n_near = 0) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const CellComplex complex =
        testing::complex_of({"random", cube, uniform_points(cube, 8, seed)});
    Workers workers(1);
    std::vector<CellHull> hulls =
        cell_hulls(complex, grain_surface(complex, std::vector<double>(8, 0.2), workers));
    if (n_near > 0) {
        hulls[0].near.assign(hulls[0].points.size(), 0);
        std::fill_n(hulls[0].near.begin(), n_near, 1);
    }
    return *fill_cell(hulls[0], 0.2);
}

/// Laws (1) and (2), against the tetrahedra one by one.
TEST(StarShape, MeasuresAsTheTetrahedraOneByOne) {
    std::mt19937_64 random(1);
    const CellTetrahedra cell = random_cell(3, 4);
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
                const double sine = smallest_sine(p[0], p[1], p[2], p[3]);
                const FourCorners& c = cell.corners(t);
                const bool is_near = *std::min_element(c.begin(), c.end()) < 4;
                least = std::min(least, is_near ? quality_at_feature(sine) : sine);
                ratios += volume_length_ratio(p[0], p[1], p[2], p[3]);
            }
            EXPECT_NEAR(shape.least_quality(way, -1), least, 1e-9);
            const StarShape::Measure all = shape.measure(way, -2);
            EXPECT_NEAR(all.least_quality, least, 1e-9);
            EXPECT_NEAR(all.sum_of_ratios, ratios, 1e-9);
            EXPECT_LE(shape.least_quality(way, 0.2), std::max(least, 0.2) + 1e-9);
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
        EXPECT_LE(shape.least_quality(cell.point(w) - cell.point(v), -1), 0);
    }
}

/// Law (1) of cell_sizes().
TEST(CellSizes, FollowTheWidthAndNameFlatCells) {
    const Points one = Points::Constant(3, 1, 0.5);
    const auto sizes_of = [&](double height, double size) {
        return cell_sizes(testing::complex_of({"flat", Lattice::box(1, 1, height), one}), size);
    };
    EXPECT_TRUE(sizes_of(0.4, 0.35).flat.empty());
    EXPECT_EQ(sizes_of(0.4, 0.35).sizes[0], 0.35);
    const CellSizes limited = sizes_of(0.1, 0.25);
    EXPECT_NEAR(limited.sizes[0], kSizeInWidth * 0.1, 1e-12);
    EXPECT_EQ(limited.flat.size(), 1u);
    const CellSizes thin = sizes_of(0.02, 0.18);
    EXPECT_EQ(thin.sizes[0], 0.18);
    ASSERT_EQ(thin.flat.size(), 1u);
    EXPECT_NEAR(thin.flat[0].angle, std::atan2(0.02, 0.18) * 180 / M_PI, 1e-9);
}

}  // namespace
}  // namespace pcvt::space
