#include "mesher/plane/density/pixel_quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesher/plane/density/cell_quadrature.hpp"
#include "mesher/plane/density/density_survey.hpp"

namespace pcvt::plane {
namespace {

const Lattice kPixelLattice({1.3, 0.2}, {0.4, 0.9});
/// The same torus in a basis that is far from reduced.
const Lattice kSkew({1.3, 0.2}, {26.4, 4.9});

PixelGrid noise(int width, int height, double black, double white) {
    std::mt19937 generator(width * 1000 + height);
    std::vector<float> greys(std::size_t(width) * height);
    for (float& grey : greys) grey = static_cast<float>(generator() % 256) / 255.0F;
    return {width, height, std::move(greys), black, white};
}

CellPolygon heptagon(const Lattice& lattice, const Vec2& site, double radius) {
    CellPolygon cell;
    for (int k = 0; k < 7; ++k) {
        const Vec2 d = radius * Vec2(std::cos(0.9 * k + 0.3), std::sin(0.9 * k + 0.3));
        cell.push_back({d, site + lattice.to_lattice(d)});
    }
    return cell;
}

/// The moments by the rules of each piece, without the sums of the grid.
Moments by_rules(const Lattice& lattice, const PixelGrid& grid, CellView cell, const Vec2& site) {
    Density density = pixel_density(grid);
    density.pixels = nullptr;
    DensityProbe probe(lattice, density.make_function());
    return CellQuadrature(density)(cell, site, kPixelOrder, probe);
}

void expect_accurate(const Moments& found, const Moments& expected, double radius,
                     double accuracy) {
    const double mass = expected.mass;
    EXPECT_NEAR(found.mass, mass, accuracy * mass);
    EXPECT_LT((found.first - expected.first).norm(), accuracy * mass * radius);
    EXPECT_NEAR(found.second, expected.second, accuracy * mass * radius * radius);
}

// Law 1, for cells smaller and larger than a pixel, in one period, across the seam and round it.
TEST(PixelQuadrature, EqualsTheRulesOnEachPiece) {
    std::int64_t n_points = 0;
    for (const auto& [width, height] : {std::pair{1, 1}, {5, 2}, {40, 50}, {3, 200}, {90, 1}}) {
        const PixelGrid grid = noise(width, height, 0.01, 1);
        for (const Lattice& lattice : {kPixelLattice, kSkew}) {
            for (const double radius : {0.004, 0.1, 0.7}) {
                for (const Vec2& site : {Vec2(0.5, 0.52), Vec2(0.99, 0.01), Vec2(0.25, 0.75)}) {
                    const CellPolygon cell = heptagon(lattice, site, radius);
                    expect_accurate(pixel_moments(grid, cell, n_points),
                                    by_rules(lattice, grid, cell, site), radius, 1e-12);
                }
            }
        }
    }
    EXPECT_GT(n_points, 0);
}

// Nothing cancels, so that dark cells beside bright ones keep their digits.
TEST(PixelQuadrature, IsAccurateForEveryContrast) {
    std::vector<float> greys(64 * 64, 0);
    for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 20; ++column) greys[row * 64 + column] = 1;
    }
    const PixelGrid grid(64, 64, greys, 1e-11, 1);
    const CellPolygon cell = heptagon(Lattice::rectangle(1, 1), {0.7, 0.5}, 0.25);
    std::int64_t n_points = 0;
    expect_accurate(pixel_moments(grid, cell, n_points),
                    by_rules(Lattice::rectangle(1, 1), grid, cell, {0.7, 0.5}), 0.25, 1e-12);
}

// Law 2.
TEST(PixelQuadrature, IsTheSameForAllTranslates) {
    const PixelGrid grid = noise(37, 41, 0.1, 2);
    std::int64_t n_points = 0;
    const Vec2 site(0.3, 0.6);
    const Moments here = pixel_moments(grid, heptagon(kPixelLattice, site, 0.4), n_points);
    for (const Vec2& offset : {Vec2(1, 0), Vec2(-1, 1), Vec2(0, -2)}) {
        const CellPolygon there = heptagon(kPixelLattice, site + offset, 0.4);
        expect_accurate(pixel_moments(grid, there, n_points), here, 0.4, 1e-12);
    }
}

// The points of a cell lie along its outline: their number grows with its length, not its area.
TEST(PixelQuadrature, EvaluatesOnlyAlongTheOutline) {
    std::int64_t n_coarse = 0;
    std::int64_t n_fine = 0;
    const CellPolygon cell = heptagon(kPixelLattice, {0.5, 0.5}, 0.4);
    pixel_moments(noise(100, 100, 0.1, 1), cell, n_coarse);
    pixel_moments(noise(400, 400, 0.1, 1), cell, n_fine);
    EXPECT_LT(double(n_fine), 4.5 * double(n_coarse));
}

// Laws 1 and 2 of PixelGrid.
TEST(PixelGrid, RunsAreTheSumsOfTheirSquares) {
    const PixelGrid grid = noise(3, 45, 0.2, 7);
    for (const auto& [row, end] : {std::pair{0, 45}, {5, 7}, {15, 33}, {40, 150}, {-7, 20}}) {
        PlainMoments sum;
        for (int at = row; at < end; ++at) sum.add(grid.run(1, at, at + 1), at - row);
        const PlainMoments whole = grid.run(1, row, end);
        const PlainMoments there = grid.run(1 + 3 * 4, row - 45 * 2, end - 45 * 2);
        for (const PlainMoments& run : {whole, there}) {
            EXPECT_NEAR(run.mass, sum.mass, 1e-13 * sum.mass);
            EXPECT_NEAR(run.s, sum.s, 1e-13 * sum.s);
            EXPECT_NEAR(run.t, sum.t, 1e-13 * sum.t);
            EXPECT_NEAR(run.ss, sum.ss, 1e-13 * sum.ss);
            EXPECT_NEAR(run.st, sum.st, 1e-13 * sum.st);
            EXPECT_NEAR(run.tt, sum.tt, 1e-13 * sum.tt);
        }
    }
}

TEST(PixelGrid, MeanIsTheIntegralByRules) {
    const PixelGrid grid = noise(7, 12, 0.01, 1);
    Density by_rules = pixel_density(grid);
    by_rules.pixels = nullptr;
    EXPECT_NEAR(grid.mean(), integral(Lattice::rectangle(1, 1), by_rules), 1e-14);
}

}  // namespace
}  // namespace pcvt::plane
