#include "mesher/plane/density/cell_sums.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "mesher/plane/density/pixel_grid.hpp"
#include "mesher/plane/energy/energy.hpp"
#include "tests/support/densities.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

/// A circle of sites round a central site, and a few others.
Points wheel(int n_spokes) {
    Points points(2, n_spokes + 3);
    for (int k = 0; k < n_spokes; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.01 * (k % 3)) / n_spokes;
        points.col(k) = Vec2(0.5 + 0.2 * std::cos(angle), 0.5 + 0.2 * std::sin(angle));
    }
    points.rightCols(3) << 0.5, 0.01, 0.02, 0.5, 0.03, 0.52;
    return points;
}

/// Three nearly collinear sites, far from all others: their triangle is thin, its circumcentre far
/// away.
Points row() {
    Points points(2, 5);
    const Vec2 along = 1e-7 * Vec2(0.8, 0.6);
    points.col(0) = Vec2(0.5, 0.5) - along;
    points.col(1) = Vec2(0.5, 0.5) + 1e-13 * Vec2(-0.6, 0.8);
    points.col(2) = Vec2(0.5, 0.5) + along;
    points.rightCols(2) << 0.1, 0.15, 0.1, 0.9;
    return points;
}

/// The cells of some sites, with rules of various orders.
class Place {
   public:
    Place(const Lattice& lattice, const Points& points, Density rho)
        : density(std::move(rho)),
          delaunay(Sites(lattice, points)),
          cells(delaunay, workers, lattice),
          quadrature(density),
          probe(lattice, density.make_function()) {
        EnergyPass(delaunay, workers).evaluate(uniform);
        cells.locate();
        for (SiteId s = 0; s < delaunay.n_sites(); ++s) ordered.push_back({s, 2 + s % 7, false});
    }
    std::vector<Moments> integrate(std::span<const OrderedCell> some) {
        std::vector<Moments> moments;
        CellSums(cells, quadrature, probe).integrate(some, moments);
        return moments;
    }
    CellPolygon polygon(SiteId site) const {
        CellList list;
        cells.unwrap({&site, 1}, list);
        CellPolygon polygon;
        list.copy(0, cells.site(site), polygon);
        return polygon;
    }

    Density density;
    Workers workers{1};
    MovingDelaunay delaunay;
    UnwrappedCells cells;
    CellQuadrature quadrature;
    DensityProbe probe;
    Energy uniform;
    std::vector<OrderedCell> ordered;
};

void expect_same(const Moments& found, const Moments& expected, double tolerance) {
    const double length = std::sqrt(expected.second / expected.mass);
    EXPECT_NEAR(found.mass / expected.mass, 1, tolerance);
    EXPECT_LT((found.first - expected.first).norm(), tolerance * expected.mass * length);
    EXPECT_NEAR(found.second / expected.second, 1, tolerance);
}

TEST(CellSums, EqualTheMomentsOfEachCellByItself) {
    Density halves = testing::smooth_density();
    halves.u_breaks = {0.5};
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const Density& density : {testing::smooth_density(), halves}) {
            SCOPED_TRACE(name);
            Place place(lattice, uniform_points(lattice, 150, 4), density);
            const std::vector<Moments> found = place.integrate(place.ordered);
            const std::int64_t n_evaluations = place.probe.take_range().n_evaluations;
            for (const auto& [site, q, is_cut] : place.ordered) {
                const Moments single =
                    place.quadrature(place.polygon(site), place.cells.site(site), q, place.probe);
                expect_same(found[site], single, 1e-12);
            }
            EXPECT_EQ(place.probe.take_range().n_evaluations, n_evaluations);
        }
    }
}

TEST(CellSums, EqualTheRulesOnPiecesOfAPicture) {
    std::vector<float> greys(16 * 9);
    for (std::size_t k = 0; k < greys.size(); ++k) greys[k] = float((k * k) % 7) / 6;
    const Density picture = pixel_density({16, 9, greys, 0.1, 1});
    Density pieces = picture;
    pieces.pixels = nullptr;
    for (const auto& [name, lattice] : testing::lattices()) {
        SCOPED_TRACE(name);
        const Points points = uniform_points(lattice, 150, 4);
        Place by_sides(lattice, points, picture);
        Place by_pieces(lattice, points, pieces);
        for (OrderedCell& cell : by_pieces.ordered) cell.q = std::max(cell.q, kPixelOrder);
        const std::vector<Moments> found = by_sides.integrate(by_pieces.ordered);
        const std::vector<Moments> expected = by_pieces.integrate(by_pieces.ordered);
        for (std::size_t k = 0; k < found.size(); ++k) expect_same(found[k], expected[k], 1e-10);
        const DensityRange range = by_sides.probe.take_range();
        EXPECT_GT(range.n_evaluations, 150 * 3 * 6);
        EXPECT_LT(range.n_evaluations, by_pieces.probe.take_range().n_evaluations);
    }
}

TEST(CellSums, AreTheSameBitsForPointsByColumns) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const auto& uses :
             {std::array{true, true, false, false}, std::array{false, false, true, true},
              std::array{true, true, true, true}}) {
            SCOPED_TRACE(name);
            const Points points = uniform_points(lattice, 150, 4);
            const auto waves = [](const DensityPoint& p) {
                return 5 + std::sin(p.x) + std::cos(3 * p.y) + p.u * p.v + std::sin(9 * p.v);
            };
            const Density columns = testing::density_of_columns(waves, uses);
            const Density rows = shared_density([&](const DensityPoint& p) {
                return testing::value_at(columns.make_function(), p);
            });
            Place by_points(lattice, points, rows);
            Place by_columns(lattice, points, columns);
            EXPECT_FALSE(by_points.probe.takes_columns());
            EXPECT_TRUE(by_columns.probe.takes_columns());
            const std::vector<Moments> expected = by_points.integrate(by_points.ordered);
            const std::vector<Moments> found = by_columns.integrate(by_columns.ordered);
            for (std::size_t k = 0; k < expected.size(); ++k) {
                EXPECT_EQ(found[k].mass, expected[k].mass);
                EXPECT_EQ(found[k].first, expected[k].first);
                EXPECT_EQ(found[k].second, expected[k].second);
            }
            const DensityRange one = by_points.probe.take_range();
            const DensityRange other = by_columns.probe.take_range();
            EXPECT_EQ(one.n_evaluations, other.n_evaluations);
            EXPECT_EQ(one.least, other.least);
            EXPECT_EQ(one.greatest, other.greatest);
        }
    }
}

/// The fault of a density with a hole in the middle of the domain.
std::string first_fault(const std::array<bool, 4>& uses) {
    const Lattice lattice({2, 0}, {0.5, 1});
    const auto hole = [&](const DensityPoint& p) {
        const bool by_position = uses[0] && std::hypot(p.x - 1.25, p.y - 0.5) < 0.1;
        return by_position || std::hypot(p.u - 0.5, p.v - 0.5) < 0.1 ? -1.0 : 1.0;
    };
    // Only cells that reach over the seam have points without columns.
    Place place(lattice, uniform_points(lattice, 300, 4), testing::density_of_columns(hole, uses));
    try {
        place.integrate(place.ordered);
    } catch (const BadDensity& fault) {
        return fault.what();
    }
    return "none";
}

TEST(CellSums, NameTheWholePointOfABadValue) {
    // Coordinates without columns are computed from the others.
    for (const auto& uses :
         {std::array{true, true, false, false}, std::array{false, false, true, true}}) {
        double x = 0;
        double y = 0;
        double u = 0;
        double v = 0;
        const std::string text = first_fault(uses);
        const std::size_t at = text.find("at x = ");
        ASSERT_NE(at, std::string::npos) << text;
        ASSERT_EQ(std::sscanf(text.c_str() + at, "at x = %lf, y = %lf (u = %lf, v = %lf)", &x, &y,
                              &u, &v),
                  4);
        EXPECT_NEAR(x, 2 * u + 0.5 * v, 1e-4);
        EXPECT_NEAR(y, v, 1e-4);
        EXPECT_LT(std::hypot(x - 1.25, y - 0.5), 0.3);
    }
}

TEST(CellSums, OfACellDependOnNoOtherCell) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    Place place(lattice, uniform_points(lattice, 700, 4), testing::smooth_density());
    const std::vector<Moments> together = place.integrate(place.ordered);
    for (const OrderedCell& cell : place.ordered) {
        const Moments single = place.integrate({&cell, 1}).front();
        EXPECT_EQ(single.mass, together[cell.site].mass);
        EXPECT_EQ(single.first, together[cell.site].first);
        EXPECT_EQ(single.second, together[cell.site].second);
    }
}

TEST(CellSums, OfUnitDensityAreTheAreasOfFewManyAndCrowdedCells) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    const Density one = shared_density([](const DensityPoint&) { return 1.0; });
    for (const Points& points : {uniform_points(lattice, 1, 1), uniform_points(lattice, 3, 1),
                                 uniform_points(lattice, 900, 1), wheel(13), wheel(40), row()}) {
        SCOPED_TRACE(points.cols());
        Place place(lattice, points, one);
        const std::vector<Moments> found = place.integrate(place.ordered);
        for (SiteId s = 0; s < place.delaunay.n_sites(); ++s) {
            const double area = place.uniform.mass[s];
            EXPECT_NEAR(found[s].mass / area, 1, 1e-10);
            const Vec2 gradient = place.uniform.gradient.segment<2>(2 * Eigen::Index{s});
            const double length = std::sqrt(found[s].second / area);
            EXPECT_LT((-2 * found[s].first - gradient).norm(), 1e-10 * area * length);
        }
    }
}

}  // namespace
}  // namespace pcvt::plane
