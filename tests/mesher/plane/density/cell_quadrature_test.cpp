#include "mesher/plane/density/cell_quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mesher/plane/density/quadrature.hpp"
#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {
namespace {

/// A regular hexagon round a site, in the plane of a lattice.
CellPolygon hexagon(const Lattice& lattice, const Vec2& site, double radius) {
    CellPolygon cell;
    for (int k = 0; k < 6; ++k) {
        const Vec2 d = radius * Vec2(std::cos(1.0 * k + 0.3), std::sin(1.0 * k + 0.3));
        cell.push_back({d, site + lattice.to_lattice(d)});
    }
    return cell;
}

Moments moments(const Lattice& lattice, const Density& density, const Vec2& site, double radius,
                int q) {
    DensityProbe probe(lattice, density.make_function());
    return CellQuadrature(density)(hexagon(lattice, site, radius), site, q, probe);
}

void expect_near(const Moments& found, const Moments& expected, double tolerance) {
    EXPECT_NEAR(found.mass, expected.mass, tolerance);
    EXPECT_NEAR(found.first.x(), expected.first.x(), tolerance);
    EXPECT_NEAR(found.first.y(), expected.first.y(), tolerance);
    EXPECT_NEAR(found.second, expected.second, tolerance);
}

const Lattice kOblique({1.3, 0.2}, {0.4, 0.9});

// Law 1 in a cell that no break line crosses.
TEST(CellMoments, OfPolynomialsAreExactToDegreeTwoQMinusThree) {
    for (int q = kLeastOrder; q < 8; ++q) {
        const Density density = shared_density(
            [q](const DensityPoint& p) { return 1 + std::pow(p.u + 2 * p.v, 2 * q - 3); });
        const Vec2 site(0.4, 0.5);
        const Moments fine = moments(kOblique, density, site, 0.2, kGreatestOrder);
        expect_near(moments(kOblique, density, site, 0.2, q), fine, 1e-14 * fine.mass);
        if (q > 4) continue;
        const Density higher = shared_density(
            [q](const DensityPoint& p) { return 1 + std::pow(p.u + 2 * p.v, 2 * q + 1); });
        EXPECT_GT(std::abs(moments(kOblique, higher, site, 0.2, q).second -
                           moments(kOblique, higher, site, 0.2, kGreatestOrder).second),
                  1e-12);
    }
}

TEST(CellMoments, OfAConstantAreTheMomentsOfTheHexagon) {
    const Density two = shared_density([](const DensityPoint&) { return 2.0; });
    // In the interior of the domain, across one side of it, and across a corner.
    for (const Vec2& site : {Vec2(0.5, 0.5), Vec2(0.99, 0.5), Vec2(1.02, -0.98)}) {
        Polygon corners;
        for (const CellCorner& c : hexagon(kOblique, site, 0.2)) corners.push_back(c.plane);
        const Moments found = moments(kOblique, two, site, 0.2, 3);
        const Vec2 first = 2 * polygon_area(corners) * polygon_centroid(corners);
        EXPECT_NEAR(found.mass, 2 * polygon_area(corners), 1e-15);
        EXPECT_LT((found.first - first).norm(), 1e-15);
    }
}

// Law 2, for a density that jumps at the seam.
TEST(CellMoments, AreEqualForAllTranslates) {
    const Density ramp =
        shared_density([](const DensityPoint& p) { return 1 + p.u * p.u + 3 * p.v; });
    for (const Vec2& site : {Vec2(0.5, 0.5), Vec2(0.95, 0.02), Vec2(0.001, 0.999)}) {
        const Moments here = moments(kOblique, ramp, site, 0.2, 3);
        for (const Vec2& offset : {Vec2(1, 0), Vec2(-1, 1), Vec2(0, -2)}) {
            expect_near(moments(kOblique, ramp, site + offset, 0.2, 3), here, 1e-14);
        }
    }
}

/// A smooth density, translated by a fraction of a period.
Density wave(double shift) {
    return shared_density([shift](const DensityPoint& p) {
        EXPECT_TRUE(p.u >= 0 && p.u < 1 && p.v >= 0 && p.v < 1);
        return 2 + std::cos(2 * M_PI * (p.u + shift)) * std::sin(2 * M_PI * (p.v + shift));
    });
}

TEST(CellMoments, AcrossTheSeamEqualTheMomentsOfAnInteriorCell) {
    for (const Vec2& site : {Vec2(0.98, 0.5), Vec2(0.02, 0.01), Vec2(0.51, 0.99)}) {
        const Moments here = moments(kOblique, wave(0), site, 0.2, 8);
        const Vec2 moved = site - Vec2::Constant(0.45);
        expect_near(moments(kOblique, wave(0.45), moved, 0.2, 8), here, 1e-11);
    }
}

/// Bilinear between the lines u = (k + 1/2) / n, v = (k + 1/2) / n.
double pixels(const DensityPoint& p, int n) {
    const auto saw = [n](double t) { return std::abs(2 * (n * t - std::floor(n * t)) - 1); };
    return 1 + saw(p.u) * saw(p.v + 0.25 / n) + 0.5 * saw(p.u);
}

// Law 1 on pieces: the cell is cut into many pieces, some of them whole parallelograms.
TEST(CellMoments, KinksAtBreakLinesCostNoAccuracy) {
    for (const int n : {1, 3, 20}) {
        Density density = shared_density([n](const DensityPoint& p) { return pixels(p, n); });
        for (int k = 0; k < 2 * n; ++k) {
            density.u_breaks.push_back(0.5 * k / n);
            const double v = 0.5 * k / n - 0.25 / n;
            density.v_breaks.push_back(v < 0 ? v + 1 : v);
        }
        for (const Vec2& site : {Vec2(0.5, 0.5), Vec2(0.95, 0.02)}) {
            const Moments coarse = moments(kOblique, density, site, 0.2, 3);
            expect_near(moments(kOblique, density, site, 0.2, 6), coarse, 1e-14);
        }
    }
}

TEST(CellMoments, JumpsAtBreakLinesAreResolved) {
    Density density = shared_density([](const DensityPoint& p) { return p.u < 0.45 ? 5.0 : 1.0; });
    const Moments rough = moments(kOblique, density, {0.4, 0.5}, 0.2, 6);
    density.u_breaks = {0.45};
    const Moments exact = moments(kOblique, density, {0.4, 0.5}, 0.2, 2);
    expect_near(moments(kOblique, density, {0.4, 0.5}, 0.2, 6), exact, 1e-15);
    EXPECT_GT(std::abs(rough.mass - exact.mass), 1e-5);
}

TEST(CellMoments, BreakLinesMustLieInTheDomain) {
    Density density = shared_density([](const DensityPoint&) { return 1.0; });
    for (const double bad : {-0.1, 1.0, std::nan("")}) {
        density.u_breaks = {bad};
        EXPECT_THROW(CellQuadrature{density}, InvalidInput) << bad;
    }
}

}  // namespace
}  // namespace pcvt::plane
