#include "mesher/plane/energy/energy.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "mesher/plane/cvt/cvt.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "tests/support/energy_at.hpp"
#include "tests/support/lattices.hpp"
#include "tests/support/special_sites.hpp"
#include "tests/support/wide_terms.hpp"

namespace pcvt::plane {
namespace {

using testing::energy_at;
using testing::lattices;
using testing::PlaneEnergy;

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
            const PlaneEnergy actual = energy_at(delaunay.sites());
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
            const PlaneEnergy at_x = energy_at(lattice, x);
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
    const PlaneEnergy e = energy_at(sites);
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
        EXPECT_NEAR(energy_at(sites).value / bound, 1, 1e-13);
    }
}

/// A triangulation whose sites move.
class Walk {
   public:
    Walk(const Sites& sites, int n_threads)
        : delaunay(sites), workers(n_threads), pass(delaunay, workers) {
        EXPECT_TRUE(pass.evaluate(energy));
    }

    void step(const Eigen::VectorXf& direction, double t) {
        EXPECT_TRUE(delaunay.step(direction, t, workers));
        EXPECT_TRUE(pass.evaluate(energy));
        delaunay.settle();
    }
    void lloyd_step(double t) {
        const Eigen::VectorXd masses = energy.mass.replicate(1, 2).transpose().reshaped();
        step((-0.5 * energy.gradient.cwiseQuotient(masses)).cast<float>(), t);
    }

    MovingDelaunay delaunay;
    Workers workers;
    EnergyPass pass;
    Energy energy;
};

// Law 5, for random sites and after moves, with repairs in between.
TEST(Energy, IsTheSameToTheLastBitForAnyNumberOfWorkers) {
    const Lattice lattice({1, 0}, {0.37, 0.81});
    const Sites sites(lattice, uniform_points(lattice, 50000, 6));
    Walk one(sites, 1);
    const Energy at_random = one.energy;
    for (int k = 0; k < 4; ++k) one.lloyd_step(1);
    EXPECT_GT(one.delaunay.counts().n_flips, 0);
    for (const int n_threads : {2, 3, 7}) {
        Walk other(sites, n_threads);
        EXPECT_EQ(other.energy.value, at_random.value);
        EXPECT_EQ(other.energy.gradient, at_random.gradient);
        EXPECT_EQ(other.energy.mass, at_random.mass);
        for (int k = 0; k < 4; ++k) other.lloyd_step(1);
        EXPECT_EQ(other.energy.value, one.energy.value);
        EXPECT_EQ(other.energy.gradient, one.energy.gradient);
        EXPECT_EQ(other.energy.mass, one.energy.mass);
    }
}

// Laws 2 and 4 in slabs large enough that their sums are cleared along with the triangles.
TEST(Energy, IsCorrectInLargeSlabs) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    Walk walk(Sites(lattice, uniform_points(lattice, 600000, 8)), 2);
    const Energy first = walk.energy;
    walk.energy.gradient.setConstant(std::numeric_limits<double>::quiet_NaN());
    walk.energy.mass.setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(walk.pass.evaluate(walk.energy));
    EXPECT_EQ(walk.energy.gradient, first.gradient);
    EXPECT_EQ(walk.energy.mass, first.mass);
    const double unit = walk.delaunay.unit();
    EXPECT_NEAR(first.mass.sum() * unit * unit, 1, 1e-11);
    const Eigen::Map<const Points> gradient(first.gradient.data(), 2, first.mass.size());
    EXPECT_LT(gradient.rowwise().sum().norm(), 1e-11 * gradient.colwise().norm().sum());
}

void expect_delaunay(const MovingDelaunay& delaunay, const Lattice& lattice) {
    TorusTriangulation t = delaunay.triangulation();
    const LawsonFlips look(t, delaunay.coordinates(), gram_of(reduce(lattice).reduced));
    for (int h = 0; h < t.n_halfedges(); ++h) {
        ASSERT_TRUE(look.is_counter_clockwise(h / 3));
        ASSERT_TRUE(look.is_locally_delaunay(h));
    }
}

/// Compares the walk's energy with that of a new triangulation of the same sites.
void expect_new_build(const Walk& walk, const Lattice& lattice) {
    const Sites sites(lattice, reduce(lattice), walk.delaunay.coordinates());
    const PlaneEnergy rebuilt = energy_at(sites);
    PlaneEnergy walked = testing::in_plane(walk.energy, walk.delaunay, lattice);
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        const SiteId id = walk.delaunay.original_id(s);
        ASSERT_LT((walked.gradient.col(id) - rebuilt.gradient.col(s)).norm(),
                  1e-12 * std::pow(sites.spacing(), 3));
        ASSERT_NEAR(walked.mass[id], rebuilt.mass[s], 1e-12 * std::pow(sites.spacing(), 2));
    }
    ASSERT_NEAR(walked.value / rebuilt.value, 1, 1e-12);
}

// Steps that flip too few edges for a second pass: the terms are corrected one by one.
TEST(Energy, CorrectionsAfterFlipsEqualASecondPass) {
    int n_corrected_steps = 0;
    for (const auto& [name, lattice] : lattices()) {
        SCOPED_TRACE(name);
        const int n = 600;
        Walk walk(Sites(lattice, uniform_points(lattice, n, 7)), 1);
        for (int k = 0; k < 40; ++k) {
            const auto flips_before = walk.delaunay.counts().n_flips;
            walk.lloyd_step(k < 10 ? 0.02 : 0.2);
            const auto n_flips = walk.delaunay.counts().n_flips - flips_before;
            n_corrected_steps += n_flips > 0 && n_flips < n / 20;
            expect_new_build(walk, lattice);
            expect_delaunay(walk.delaunay, lattice);
        }
        EXPECT_EQ(walk.delaunay.counts().n_rebuilds, 0);
    }
    EXPECT_GT(n_corrected_steps, 100);
}

/// Moves one site to `height` h above a point of the side opposite to halfedge h's origin.
Eigen::VectorXf flattening(const MovingDelaunay& delaunay, int h, double part, double height) {
    const TorusTriangulation& t = delaunay.triangulation();
    const auto at = [&](int g) {
        return image(delaunay.coordinates(), t.corner(g).site, t.corner(g).offset);
    };
    const int next = TorusTriangulation::next(h);
    const Vec2 p = delaunay.frame().to_position(difference(at(h), at(next)));
    const Vec2 q =
        delaunay.frame().to_position(difference(at(h), at(TorusTriangulation::next(next))));
    const Vec2 above(p.y() - q.y(), q.x() - p.x());
    const Vec2 move = p + part * (q - p) + height * delaunay.spacing() * above.normalized();
    Eigen::VectorXf direction = Eigen::VectorXf::Zero(2 * delaunay.n_sites());
    direction.segment<2>(2 * t.corner(h).site) = move.cast<float>();
    return direction;
}

// A site comes so close to the opposite side of its triangle that cotangents are large and F does
// not resolve the terms that a flip subtracts.
TEST(Energy, KeepsTwelveDigitsAfterFlatTriangles) {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> uniform(0.2, 0.8);
    for (const auto& [name, lattice] : lattices()) {
        SCOPED_TRACE(name);
        Walk walk(Sites(lattice, uniform_points(lattice, 200, 9)), 1);
        for (int k = 0; k < 30; ++k) {
            const int h = static_cast<int>(random() % 1200);
            const double height = std::pow(10, -(k % 6));
            walk.step(flattening(walk.delaunay, h, uniform(random), height), 1);
            expect_new_build(walk, lattice);
            expect_delaunay(walk.delaunay, lattice);
        }
        EXPECT_GT(walk.delaunay.counts().n_flips, 30);
    }
}

/// The sum of the triangles' terms, each in fifty digits.
Energy wide_energy(const MovingDelaunay& delaunay) {
    const TorusTriangulation& t = delaunay.triangulation();
    const int n = delaunay.n_sites();
    Energy sum{0, Eigen::VectorXd::Zero(2 * n), Eigen::VectorXd::Zero(n)};
    for (int h = 0; h < t.n_halfedges(); h += 3) {
        std::array<Image, 3> at;
        for (int k = 0; k < 3; ++k) {
            const Corner c = t.corner(h + k);
            at[k] = image(delaunay.coordinates(), c.site, c.offset);
        }
        const testing::WideTerms terms = testing::wide_terms(
            difference(at[0], at[1]), difference(at[0], at[2]), delaunay.frame());
        sum.value += terms.value;
        for (int k = 0; k < 3; ++k) {
            sum.gradient.segment<2>(2 * at[k].site) += terms.gradient[k];
            sum.mass[at[k].site] += terms.mass[k];
        }
    }
    return sum;
}

void expect_exact_sum(const Walk& walk) {
    const Energy wide = wide_energy(walk.delaunay);
    EXPECT_NEAR(walk.energy.value / wide.value, 1, 1e-13);
    EXPECT_LT((walk.energy.gradient - wide.gradient).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((walk.energy.mass - wide.mass).cwiseAbs().maxCoeff(), 1e-12);
}

/// Expects twelve digits relative to F, to the largest mass, and to the gradient of a cell whose
/// site is as far from its centroid as points of the domain are from their sites.
void expect_twelve_digits(const Walk& walk) {
    const Energy wide = wide_energy(walk.delaunay);
    const double mass = wide.mass.maxCoeff();
    const double gradient = 2 * mass * std::sqrt(wide.value / wide.mass.sum());
    EXPECT_NEAR(walk.energy.value / wide.value, 1, 1e-12);
    EXPECT_LT((walk.energy.gradient - wide.gradient).cwiseAbs().maxCoeff(), 1e-12 * gradient);
    EXPECT_LT((walk.energy.mass - wide.mass).cwiseAbs().maxCoeff(), 1e-12 * mass);
}

// A row of sites separates along a torus that is thinner than h: flips subtract terms that are
// large for the length of their sides, at angles that are not flat.
TEST(Energy, KeepsTwelveDigitsOnTheThinnestTori) {
    std::mt19937_64 random(10);
    std::uniform_real_distribution<double> uniform;
    for (const double length : {5, 20, 100}) {
        const Lattice lattice = Lattice::rectangle(1, length);
        for (int k = 0; k < 2000; ++k) {
            const int n = 2 + k % 5;
            Points row(2, n);
            Eigen::VectorXf direction(2 * n);
            for (int s = 0; s < n; ++s) {
                row.col(s) << uniform(random), 0.02 * length * uniform(random);
                direction.segment<2>(2 * s) << 0, float(length * (uniform(random) - 0.5));
            }
            SCOPED_TRACE("1 x " + std::to_string(length) + ", " + std::to_string(k));
            Walk walk(Sites(lattice, row), 1);
            walk.step(direction, 1 / walk.delaunay.unit());
            expect_twelve_digits(walk);
        }
    }
}

// Pairs of sites at a distance of 1e-9 h that rotate round each other: thin triangles appear and
// vanish.
TEST(Energy, KeepsTwelveDigitsWhereSitesAlmostCoincide) {
    std::mt19937_64 random(8);
    std::normal_distribution<float> normal;
    const int n = 60;
    Eigen::VectorXf direction(2 * n);
    std::int64_t n_flips = 0;
    for (const auto& [name, lattice] : lattices()) {
        SCOPED_TRACE(name);
        const double near = 1e-9 * std::sqrt(lattice.area() / n);
        Points points = uniform_points(lattice, n, 8);
        for (float& d : direction) d = normal(random);
        for (int s = 0; s < n; s += 2) {
            points.col(s + 1) = points.col(s) + near * direction.segment<2>(s).cast<double>();
        }
        Walk walk(Sites(lattice, points), 1);
        expect_exact_sum(walk);
        for (const double length : {1e-10, 1e-9, 2e-10, 5e-9}) {
            for (float& d : direction) d = normal(random);
            walk.step(direction, length);
            expect_exact_sum(walk);
            expect_delaunay(walk.delaunay, lattice);
        }
        n_flips += walk.delaunay.counts().n_flips;
    }
    EXPECT_GT(n_flips, 100);
}

}  // namespace
}  // namespace pcvt::plane
