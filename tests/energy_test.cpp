#include "mesher/energy.hpp"

#include <gtest/gtest.h>

#include "mesher/cvt.hpp"
#include "mesher/voronoi.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"

namespace pcvt {
namespace {

using testing::lattices;

Energy energy_at(const Lattice& lattice, const Points& points) {
    return energy(PeriodicDelaunay(Sites(lattice, points)));
}

struct Moments {
    double energy = 0;
    double mass = 0;
    Vec2 first = Vec2::Zero();
};

/// Integrals of |p - x|^2, 1 and p - x over a cell, from its corners (Green's theorem).
Moments moments(const PeriodicMesh& cells, int f, const Vec2& x) {
    Moments sum;
    const auto corner = [&](int c) {
        return Vec2(cells.vertices[cells.corner_vertex[c]] +
                    cells.lattice.translation(cells.corner_offset[c]) - x);
    };
    for (int c = cells.face_begin[f]; c < cells.face_begin[f + 1]; ++c) {
        const Vec2 p = corner(c);
        const Vec2 q = corner(cells.next(c));
        const double cross = p.x() * q.y() - p.y() * q.x();
        sum.mass += cross / 2;
        sum.first += cross / 6 * (p + q);
        sum.energy += cross / 12 * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
    }
    return sum;
}

TEST(Energy, EqualsTheIntegralsOverTheCellPolygons) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 3, 7, 40}) {
            const PeriodicDelaunay delaunay(Sites(lattice, uniform_points(lattice, n, 1)));
            const Energy actual = energy(delaunay);
            const PeriodicMesh cells = cell_mesh(delaunay);
            double total = 0;
            const double length = std::pow(delaunay.sites().spacing(), 3);
            for (SiteId s = 0; s < n; ++s) {
                const Moments m = moments(cells, s, delaunay.sites().position(s));
                total += m.energy;
                EXPECT_NEAR(actual.mass[s], m.mass, 1e-11 * lattice.area()) << name;
                EXPECT_LT((actual.gradient.col(s) + 2 * m.first).norm(), 1e-9 * n * length) << name;
            }
            EXPECT_NEAR(actual.value, total, 1e-10 * total) << name << n;
        }
    }
}

TEST(Energy, GradientEqualsCentralDifferences) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {2, 3, 8, 30}) {
            const Points x = uniform_points(lattice, n, 2);
            const Energy at_x = energy_at(lattice, x);
            const double step = 1e-5 * std::sqrt(lattice.area() / n);
            for (Eigen::Index k = 0; k < std::min<Eigen::Index>(2 * n, 12); ++k) {
                Points ahead = x;
                Points behind = x;
                ahead.reshaped()[k] += step;
                behind.reshaped()[k] -= step;
                const double slope =
                    (energy_at(lattice, ahead).value - energy_at(lattice, behind).value) /
                    (2 * step);
                EXPECT_NEAR(at_x.gradient.reshaped()[k], slope, 1e-6 * at_x.gradient.norm())
                    << name << " n = " << n;
            }
        }
    }
}

// Law 1.
TEST(Energy, IsUnchangedByALatticeTranslationOfAnySite) {
    for (const auto& [name, lattice] : lattices()) {
        const Points x = uniform_points(lattice, 9, 3);
        Points moved = x;
        moved.col(4) += lattice.translation({2, -1});
        moved.col(7) -= lattice.b();
        EXPECT_NEAR(energy_at(lattice, moved).value / energy_at(lattice, x).value, 1, 1e-12)
            << name;
    }
}

// Laws 2, 3 and 4, where sites are random and where they are cocircular.
void expect_sums(const Sites& sites, const std::string& name) {
    const Energy e = energy(PeriodicDelaunay(sites));
    const double area = sites.lattice().area();
    const double size = e.gradient.cwiseAbs().sum() + std::pow(area, 1.5);
    EXPECT_LT(e.gradient.rowwise().sum().norm(), 1e-13 * size) << name;
    EXPECT_GE(e.value, hexagonal_bound(area, sites.n_sites()) * (1 - 1e-13)) << name;
    EXPECT_NEAR(e.mass.sum(), area, 1e-13 * area * sites.n_sites()) << name;
    EXPECT_GT(e.mass.minCoeff(), 0) << name;
}

TEST(Energy, SumsObeyTheLaws) {
    for (const auto& [name, lattice] : lattices()) {
        for (const int n : {1, 2, 5, 200})
            expect_sums({lattice, uniform_points(lattice, n, 4)}, name);
    }
    for (const auto& [name, sites] : testing::special_sites()) expect_sums(sites, name);
}

TEST(Energy, OfRegularHexagonsIsTheBound) {
    const Lattice hexagonal({1, 0}, {0.5, std::sqrt(0.75)});
    for (const int k : {1, 2, 5}) {
        const Sites sites = testing::grid_sites(hexagonal, k, k, 0.1, 0.2);
        const double bound = hexagonal_bound(hexagonal.area(), k * k);
        EXPECT_NEAR(energy(PeriodicDelaunay(sites)).value / bound, 1, 1e-13);
    }
}

}  // namespace
}  // namespace pcvt
