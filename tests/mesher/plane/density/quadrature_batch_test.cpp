#include "mesher/plane/density/quadrature_batch.hpp"

#include <gtest/gtest.h>

#include "mesher/plane/density/cell_quadrature.hpp"
#include "tests/support/densities.hpp"
#include "tests/support/example_lattices.hpp"

namespace pcvt::plane {
namespace {

using testing::kSquare;

/// A square round a site; near the seam it is cut.
CellPolygon square(const Vec2& site, double half) {
    CellPolygon cell;
    for (const Vec2& corner :
         {Vec2(-half, -half), Vec2(half, -half), Vec2(half, half), Vec2(-half, half)}) {
        cell.push_back({corner, site + corner});
    }
    return cell;
}

/// Sites, some of them near the seam, with rules of various orders.
std::vector<std::pair<Vec2, int>> some_cells() {
    std::vector<std::pair<Vec2, int>> cells;
    for (int k = 0; k < 40; ++k) cells.push_back({Vec2(0.31 * k - 3, 0.17 * k), 2 + k % 6});
    return cells;
}

TEST(QuadratureBatch, ComputesTheMomentsOfEachCellToTheLastBit) {
    const Density density = testing::ramp_density();
    const CellQuadrature quadrature(density);
    DensityProbe probe(kSquare, density.make_function());
    DensityProbe other(kSquare, density.make_function());
    QuadratureBatch batch(probe);
    for (const double half : {0.1, 0.07}) {
        for (const auto& [site, q] : some_cells())
            quadrature.add(square(site, half), site, q, batch);
        const std::vector<Moments>& found = batch.collect();
        ASSERT_EQ(found.size(), some_cells().size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            const auto [site, q] = some_cells()[k];
            const Moments single = quadrature(square(site, half), site, q, other);
            EXPECT_EQ(found[k].mass, single.mass);
            EXPECT_EQ(found[k].first, single.first);
            EXPECT_EQ(found[k].second, single.second);
        }
    }
}

TEST(QuadratureBatch, EvaluatesTheDensityOnceForAllItsCells) {
    int n_calls = 0;
    std::size_t n_points = 0;
    const Density density{[&] {
        return [&](std::span<const DensityPoint> points, std::span<double> rho) {
            ++n_calls;
            n_points += points.size();
            std::fill(rho.begin(), rho.end(), 1.0);
        };
    }};
    const CellQuadrature quadrature(density);
    DensityProbe probe(kSquare, density.make_function());
    QuadratureBatch batch(probe);
    for (int k = 0; k < 9; ++k) quadrature.add(square({0.5, 0.5}, 0.1), {0.5, 0.5}, 3, batch);
    EXPECT_EQ(n_calls, 0);
    EXPECT_EQ(batch.collect().size(), 9);
    EXPECT_EQ(n_calls, 1);
    EXPECT_EQ(n_points, 9 * 4 * 9);
    EXPECT_TRUE(batch.collect().empty());
}

}  // namespace
}  // namespace pcvt::plane
