#include "mesher/plane/density/pixel_quadrature.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

Eigen::Matrix2d from_plane(const Lattice& lattice) {
    Eigen::Matrix2d matrix;
    matrix << lattice.to_lattice({1, 0}), lattice.to_lattice({0, 1});
    return matrix;
}

/// The moments by the sums of the grid.
Moments by_sums(const Lattice& lattice, const PixelGrid& grid, CellView cell, const Vec2& site) {
    return PixelQuadrature(grid, from_plane(lattice))(cell, site);
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
    for (const auto& [width, height] : {std::pair{1, 1}, {5, 2}, {40, 50}, {3, 200}, {90, 1}}) {
        const PixelGrid grid = noise(width, height, 0.01, 1);
        for (const Lattice& lattice : {kPixelLattice, kSkew}) {
            const double accuracy = lattice.b().x() > 1 ? 1e-11 : 1e-12;
            for (const double radius : {0.004, 0.1, 0.7}) {
                for (const Vec2& site : {Vec2(0.5, 0.52), Vec2(0.99, 0.01), Vec2(0.25, 0.75)}) {
                    const CellPolygon cell = heptagon(lattice, site, radius);
                    expect_accurate(by_sums(lattice, grid, cell, site),
                                    by_rules(lattice, grid, cell, site), radius, accuracy);
                }
            }
        }
    }
}

// Law 3: dark cells beside bright ones keep their digits.
TEST(PixelQuadrature, IsAccurateForEveryContrast) {
    std::vector<float> greys(64 * 64, 0);
    for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 20; ++column) greys[row * 64 + column] = 1;
    }
    const PixelGrid grid(64, 64, greys, 1e-11, 1);
    const CellPolygon cell = heptagon(Lattice::rectangle(1, 1), {0.7, 0.5}, 0.25);
    expect_accurate(by_sums(Lattice::rectangle(1, 1), grid, cell, {0.7, 0.5}),
                    by_rules(Lattice::rectangle(1, 1), grid, cell, {0.7, 0.5}), 0.25, 1e-12);
}

// Law 3, where the cell crosses the edge of the bright part: the upper and the lower sides cross
// squares of their own, so that nothing cancels.
TEST(PixelQuadrature, IsAccurateWhereTheContrastLiesInTheCell) {
    std::vector<float> greys(64 * 64, 0);
    for (int row = 0; row < 64; ++row) greys[row * 64 + 40] = 1;
    const PixelGrid grid(64, 64, greys, 1e-11, 1);
    const Lattice square = Lattice::rectangle(1, 1);
    for (const Vec2& site : {Vec2(0.6, 0.5), Vec2(0.6, 0.507)}) {
        const CellPolygon cell = heptagon(square, site, 0.2);
        expect_accurate(by_sums(square, grid, cell, site), by_rules(square, grid, cell, site), 0.2,
                        1e-12);
    }
}

// Squares that sides pass through corner to corner, along lines, and with corners on lines.
TEST(PixelQuadrature, SidesMayLieOnLinesOfTheGrid) {
    const Lattice square = Lattice::rectangle(1, 1);
    const PixelGrid grid = noise(8, 8, 0.1, 1);
    // The site lies at the centre of a pixel: a crossing of two lines.
    const Vec2 site(0.5625, 0.4375);
    const auto around = [&](std::initializer_list<Vec2> corners) {
        CellPolygon cell;
        for (const Vec2& corner : corners) cell.push_back({corner, site + corner});
        return cell;
    };
    const double h = 0.125;
    for (const CellPolygon& cell :
         {around({{-h, -h}, {h, -h}, {h, h}, {-h, h}}), around({{0, -h}, {h, 0}, {0, h}, {-h, 0}}),
          around({{-2 * h, -h}, {0, -3 * h}, {2 * h, -h}, {h, 2 * h}, {-h, 2 * h}}),
          around({{-h / 3, -h / 2}, {h / 3, -h / 2}, {0, h / 2}}),
          around({{-4 * h, 0}, {0, -h / 8}, {4 * h, 0}, {0, h / 8}})}) {
        const Moments expected = by_rules(square, grid, cell, site);
        expect_accurate(by_sums(square, grid, cell, site), expected, 0.3, 1e-13);
    }
}

// Random cells in random places, from a thousandth of a pixel to several periods.
TEST(PixelQuadrature, EqualsTheRulesForRandomCells) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int k = 0; k < 300; ++k) {
        const PixelGrid grid = noise(1 + k % 9, 1 + k % 40, 0.01, 1);
        const Lattice lattice({1.3, uniform(generator)}, {uniform(generator) - 0.5, 0.9});
        const Vec2 site(uniform(generator), uniform(generator));
        const double radius = 2 * std::pow(1e-5, uniform(generator));
        // Corners on an ellipse, which makes the cell convex.
        std::vector<double> angles;
        const int n = 5 + k % 4;
        for (int c = 0; c < n; ++c) angles.push_back(6.28 * (c + uniform(generator)) / n);
        std::sort(angles.begin(), angles.end());
        CellPolygon cell;
        for (const double angle : angles) {
            const Vec2 d = radius * Vec2(std::cos(angle), 0.3 * std::sin(angle));
            cell.push_back({d, site + lattice.to_lattice(d)});
        }
        const Moments expected = by_rules(lattice, grid, cell, site);
        const double area = expected.mass / radius / radius;
        // Thin cells have less mass than the square of their size.
        expect_accurate(by_sums(lattice, grid, cell, site), expected, radius,
                        1e-11 * std::max(1.0, 1e-3 / area));
    }
}

// Where a side ends on a line, rounding may leave a segment beyond it.
TEST(PixelQuadrature, CellsMayEndOnLinesOfTheGrid) {
    const Lattice square = Lattice::rectangle(1, 1);
    const PixelGrid grid = noise(512, 8, 0.1, 1);
    const Vec2 site(256.5 / 512, 0.4);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(0, 0.4);
    for (int k = 0; k < 100; ++k) {
        CellPolygon cell;
        for (const Vec2& corner : {Vec2(-150.0 / 512, 0.1 - uniform(generator) / 2),
                                   Vec2(uniform(generator) - 0.2, -0.3 - uniform(generator)),
                                   Vec2(170.0 / 512, 0.1 - uniform(generator) / 2),
                                   Vec2(uniform(generator) - 0.2, 0.3 + uniform(generator))}) {
            cell.push_back({corner, site + corner});
        }
        expect_accurate(by_sums(square, grid, cell, site), by_rules(square, grid, cell, site), 0.5,
                        1e-12);
    }
}

TEST(PixelQuadrature, OneObjectServesManyCells) {
    const PixelGrid grid = noise(40, 50, 0.1, 1);
    const Vec2 site(0.3, 0.6);
    PixelQuadrature integrate(grid, from_plane(kPixelLattice));
    for (const double radius : {0.4, 0.01, 0.1, 0.3, 0.02}) {
        const CellPolygon cell = heptagon(kPixelLattice, site, radius);
        const Moments found = integrate(cell, site);
        const Moments expected = by_sums(kPixelLattice, grid, cell, site);
        EXPECT_EQ(found.mass, expected.mass);
        EXPECT_EQ(found.first, expected.first);
        EXPECT_EQ(found.second, expected.second);
    }
}

TEST(PixelQuadrature, CountsAsEvaluations) {
    const Density density = pixel_density(noise(40, 50, 0.1, 1));
    DensityProbe probe(kPixelLattice, density.make_function());
    const Vec2 site(0.3, 0.6);
    const CellQuadrature quadrature(density);
    quadrature(heptagon(kPixelLattice, site, 0.2), site, kPixelOrder, probe);
    const DensityRange range = probe.take_range();
    EXPECT_GT(range.n_evaluations, 100);
    EXPECT_EQ(range.least, density.pixels->range().least);
}

// Law 2.
TEST(PixelQuadrature, IsTheSameForAllTranslates) {
    const PixelGrid grid = noise(37, 41, 0.1, 2);
    const Vec2 site(0.3, 0.6);
    const auto moments_at = [&](const Vec2& place) {
        return by_sums(kPixelLattice, grid, heptagon(kPixelLattice, place, 0.4), place);
    };
    for (const Vec2& offset : {Vec2(1, 0), Vec2(-1, 1), Vec2(0, -2)}) {
        expect_accurate(moments_at(site + offset), moments_at(site), 0.4, 1e-12);
    }
}

// The points of a cell lie along its outline: their number grows with its length, not its area.
TEST(PixelQuadrature, EvaluatesOnlyAlongTheOutline) {
    const Vec2 site(0.5, 0.5);
    const CellPolygon cell = heptagon(kPixelLattice, site, 0.4);
    const auto n_evaluations = [&](int n_pixels) {
        const PixelGrid grid = noise(n_pixels, n_pixels, 0.1, 1);
        PixelQuadrature integrate(grid, from_plane(kPixelLattice));
        integrate(cell, site);
        return double(integrate.take_range().n_evaluations);
    };
    EXPECT_GT(n_evaluations(100), 100);
    EXPECT_LT(n_evaluations(400), 4.5 * n_evaluations(100));
}

// Laws 1 and 2 of PixelGrid.
TEST(PixelGrid, RunsAreTheSumsOfTheirSquares) {
    const PixelGrid grid = noise(3, 45, 0.2, 7);
    for (const auto& [row, end] : {std::pair{0, 45}, {5, 7}, {15, 33}, {40, 150}, {-7, 20}}) {
        LineMoments left;
        LineMoments right;
        for (int at = row; at < end; ++at) {
            // The rule is exact for a linear density times t^2.
            const PixelGrid::Square f = grid.square(1, at);
            for (int k = 0; k < 2; ++k) {
                const double t = line_rule(2).nodes[k];
                const double w = line_rule(2).weights[k];
                const double up = at - row + t;
                const double rho = f.low_left + t * (f.high_left - f.low_left);
                const double rho_right = f.low_right + t * (f.high_right - f.low_right);
                left.add({w * rho, w * rho * up, w * rho * up * up}, 0);
                right.add({w * rho_right, w * rho_right * up, w * rho_right * up * up}, 0);
            }
        }
        for (const PixelGrid::Run& run :
             {grid.run(1, row, end), grid.run(1 + 3 * 4, row - 45 * 2, end - 45 * 2)}) {
            for (const auto& [found, expected] :
                 {std::pair{run.left, left}, std::pair{run.right, right}}) {
                EXPECT_NEAR(found.mass, expected.mass, 1e-13 * expected.mass);
                EXPECT_NEAR(found.t, expected.t, 1e-13 * expected.t);
                EXPECT_NEAR(found.tt, expected.tt, 1e-13 * expected.tt);
            }
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
