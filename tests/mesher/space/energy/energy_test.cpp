#include "mesher/space/energy/energy.hpp"

#include <gtest/gtest.h>

#include "mesher/space/delaunay/periodic_delaunay.hpp"
#include "mesher/space/energy/tetrahedron_terms.hpp"
#include "tests/support/space_cells.hpp"
#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

using testing::Cubic;

struct Evaluated {
    Energy energy;
    Suspects suspects;
};

Evaluated evaluated(const PeriodicDelaunay& delaunay, int n_threads = 1) {
    Workers workers(n_threads);
    Evaluated result;
    result.suspects =
        EnergySums().run(delaunay.tetrahedra, delaunay.sites.coordinates(),
                         Frame(delaunay.sites.reduction().reduced, 1), workers, result.energy);
    return result;
}

Energy energy_of(const Sites& sites) { return evaluated(periodic_delaunay(sites)).energy; }

/// F n^(2/3) / (3 V^(5/3))
double normalised(const Sites& sites, const Energy& energy) {
    const double volume = sites.lattice().volume();
    return energy.value * std::cbrt(double(sites.n_sites()) * sites.n_sites()) /
           (3 * std::pow(volume, 5.0 / 3));
}

TEST(Frame, IsARotationOfTheReducedBasis) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        SCOPED_TRACE(name);
        const Lattice reduced = reduce(lattice).reduced;
        const Frame frame(reduced, 2);
        EXPECT_NEAR(8 * frame.volume(), reduced.volume(), 1e-12 * reduced.volume());
        for (const Vec3& u : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.3, -2, 1.4)}) {
            const double length = reduced.to_position(u).norm();
            EXPECT_NEAR(2 * frame.to_position(u).norm(), length, 1e-13 * length);
            EXPECT_LT((frame.to_lattice(frame.to_position(u)) - u).norm(), 1e-13);
        }
    }
}

TEST(Energy, SlowEqualsClippedCells) {
    for (const auto& [name, sites] : testing::space_site_families(7)) {
        if (sites.n_sites() > 9) continue;
        SCOPED_TRACE(name);
        const Energy energy = energy_of(sites);
        const auto brute = testing::brute_force_energy(sites);
        EXPECT_NEAR(energy.value, brute.value, 1e-11 * brute.value);
        const double volume = sites.lattice().volume();
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            EXPECT_NEAR(energy.mass[s], brute.volumes[s], 1e-11 * volume);
            const double length = brute.gradient[s].norm();
            EXPECT_NEAR(energy.gradient.segment<3>(MovingTetrahedra::kNumbersPerSite * s).norm(),
                        length, 1e-11 * (length + volume * sites.reduction().reduced.c().norm()));
        }
    }
}

TEST(Energy, GradientEqualsDifferences) {
    std::mt19937_64 random(8);
    for (int job = 0; job < 20; ++job) {
        const Lattice lattice = testing::random_space_lattice(random);
        const int n = 1 + int(random() % 12);
        const Sites sites(lattice, uniform_points(lattice, n, random()));
        const Energy energy = energy_of(sites);
        const Frame frame(sites.reduction().reduced, 1);
        const auto s = SiteId(random() % std::uint64_t(n));
        const double step = 1e-5 * sites.spacing();
        for (int axis = 0; axis < 3; ++axis) {
            const auto moved = [&](double t) {
                Points u = sites.coordinates();
                u.col(s) += snapped_displacement(frame.to_lattice(t * Vec3::Unit(axis)));
                return energy_of(Sites(lattice, sites.reduction(), u)).value;
            };
            const double difference = (moved(step) - moved(-step)) / (2 * step);
            EXPECT_NEAR(energy.gradient[MovingTetrahedra::kNumbersPerSite * s + axis], difference,
                        1e-6 * lattice.volume() * sites.spacing());
        }
    }
}

TEST(Energy, DoesNotChangeWithTranslations) {  // law 1
    const Lattice lattice = testing::space_lattices()[6].lattice;
    const Points points = uniform_points(lattice, 50, 1);
    Points moved = points;
    for (Eigen::Index s = 0; s < 50; ++s) {
        moved.col(s) += lattice.translation({int(s % 3), int(s % 4) - 2, 1});
    }
    moved.colwise() += Vec3(0.3, 0.2, 0.1);
    const double value = energy_of(Sites(lattice, points)).value;
    EXPECT_NEAR(energy_of(Sites(lattice, moved)).value, value, 1e-12 * value);
}

TEST(Energy, SlowSumsAndBound) {  // laws 2 to 4
    for (const auto& [name, sites] : testing::space_site_families(9)) {
        SCOPED_TRACE(name);
        const Energy energy = energy_of(sites);
        const double volume = sites.lattice().volume();
        EXPECT_NEAR(energy.mass.sum(), volume, 1e-12 * volume);
        EXPECT_GT(energy.mass.minCoeff(), 0);
        const auto gradient =
            energy.gradient.reshaped(MovingTetrahedra::kNumbersPerSite, sites.n_sites());
        EXPECT_LT(gradient.rowwise().sum().norm(),
                  1e-11 * volume * sites.reduction().reduced.c().norm());
        const double radius = std::cbrt(3 * volume / sites.n_sites() / (4 * std::acos(-1.0)));
        EXPECT_GT(energy.value, 0.6 * volume * radius * radius);
    }
}

TEST(Energy, ThreadsChangeNoBit) {  // law 5
    const Lattice cube = Lattice::box(1, 1, 1);
    const PeriodicDelaunay delaunay =
        periodic_delaunay(Sites(cube, uniform_points(cube, 20'000, 1)));
    const Evaluated one = evaluated(delaunay, 1);
    const Evaluated three = evaluated(delaunay, 3);
    EXPECT_EQ(one.energy.value, three.energy.value);
    EXPECT_EQ(one.energy.gradient, three.energy.gradient);
    EXPECT_EQ(one.energy.mass, three.energy.mass);
    EXPECT_EQ(one.suspects.facets, three.suspects.facets);
}

TEST(Energy, EqualsClosedFormsOfCubicLattices) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const auto expect = [&](Cubic kind, int m, double g) {
        const Sites sites(cube, testing::cubic_points(kind, m));
        SCOPED_TRACE(sites.n_sites());
        const Energy energy = energy_of(sites);
        EXPECT_NEAR(normalised(sites, energy), g, 1e-13);
        EXPECT_LT(energy.gradient.cwiseAbs().maxCoeff(), 1e-14);
    };
    for (const int m : {1, 2, 3, 4}) {
        expect(Cubic::kBodyCentred, m, 19.0 / (192.0 * std::cbrt(2.0)));
        expect(Cubic::kFaceCentred, m, std::pow(2.0, -11.0 / 3));
        expect(Cubic::kSimple, m, 1.0 / 12);
    }
}

/// Sites that are nearly cospherical have flat tetrahedra, whose circumcentres doubles do not give.
TEST(Energy, IsAccurateWhereTetrahedraAreFlat) {
    const Lattice cube = Lattice::box(1, 1, 1);
    std::mt19937_64 random(12);
    const auto expect = [&](Cubic kind, int m, double g) {
        Points points = testing::cubic_points(kind, m);
        for (double& x : points.reshaped()) x += (double(random() % 3) - 1) / kGrid;
        const Sites sites(cube, points);
        SCOPED_TRACE(sites.n_sites());
        const Energy energy = energy_of(sites);
        EXPECT_NEAR(normalised(sites, energy), g, 1e-13);
        EXPECT_LT(energy.gradient.cwiseAbs().maxCoeff(), 1e-14);
        const double cell = 1.0 / sites.n_sites();
        EXPECT_LT((energy.mass.array() - cell).abs().maxCoeff(), 1e-14);
    };
    for (const int m : {1, 2, 3, 4, 5}) {
        expect(Cubic::kBodyCentred, m, 19.0 / (192.0 * std::cbrt(2.0)));
        expect(Cubic::kFaceCentred, m, std::pow(2.0, -11.0 / 3));
        expect(Cubic::kSimple, m, 1.0 / 12);
    }
}

/// The certificate: a tetrahedron that is not positive is among the suspects, and so is, on both or
/// either side, a facet between positive tetrahedra that is not locally Delaunay.
void expect_suspects(const PeriodicDelaunay& delaunay, const Points& u) {
    const Lattice& reduced = delaunay.sites.reduction().reduced;
    const TorusTetrahedra& tetrahedra = delaunay.tetrahedra;
    Workers workers(1);
    Energy energy;
    const Suspects suspects = EnergySums().run(tetrahedra, u, Frame(reduced, 1), workers, energy);
    const std::set<int> facets(suspects.facets.begin(), suspects.facets.end());
    const std::set<int> thin(suspects.tetrahedra.begin(), suspects.tetrahedra.end());
    const Gram gram = gram_of(reduced);
    std::vector<bool> positive;
    for (int t = 0; t < tetrahedra.n_tetrahedra(); ++t) {
        positive.push_back(is_positive(tetrahedra, u, t));
        EXPECT_TRUE(positive[t] || thin.contains(t));
    }
    for (int f = 0; f < tetrahedra.n_facets(); ++f) {
        const int o = tetrahedra.opposite(f);
        if (!positive[f / 4] || !positive[o / 4]) continue;
        if (is_locally_delaunay(tetrahedra, u, gram, f)) continue;
        EXPECT_TRUE(facets.contains(f) || facets.contains(o));
    }
}

TEST(Suspects, SlowContainEverythingThatIsWrong) {
    std::mt19937_64 random(10);
    std::normal_distribution<double> normal;
    for (auto& [name, sites] : testing::space_site_families(11)) {
        SCOPED_TRACE(name);
        Points u = sites.coordinates();
        const double noise = 0.2 * sites.spacing() / sites.reduction().reduced.c().norm();
        for (double& x : u.reshaped()) {
            x = std::nearbyint((x + noise * normal(random)) * kGrid) / kGrid;
        }
        expect_suspects(periodic_delaunay(sites), u);
    }
}

/// A step of one unit of the grid decides about the facets of cospherical sites, many of whose
/// tetrahedra are flat.
TEST(Suspects, ContainWhatTheLeastStepMakesWrong) {
    const Lattice cube = Lattice::box(1, 1, 1);
    std::mt19937_64 random(13);
    for (const Cubic kind : {Cubic::kSimple, Cubic::kBodyCentred, Cubic::kFaceCentred}) {
        for (const int m : {2, 3, 5}) {
            const Sites sites(cube, testing::cubic_points(kind, m));
            SCOPED_TRACE(sites.n_sites());
            Points u = sites.coordinates();
            for (double& x : u.reshaped()) x += (double(random() % 3) - 1) / kGrid;
            expect_suspects(periodic_delaunay(sites), u);
        }
    }
}

/// The volume of a flat tetrahedron is all rounding, and with it the size of its heights, which
/// must not outweigh those beyond its facets.
TEST(TetrahedronBlock, AFlatTetrahedronCertifiesNoFacet) {
    TetrahedronBlock block;
    const std::array<Vec3, 3> edges{Vec3(1, 0, 0), Vec3(0.25, 1, 0), Vec3(0.25, 0.5, 0x1p-30)};
    for (int k = 0; k < TetrahedronBlock::kSize; ++k) {
        for (int c = 0; c < 9; ++c) block.corner[c / 3][c % 3][k] = edges[c / 3][c % 3];
    }
    Frame frame;
    frame.gram = gram_of(Lattice::box(1, 1, 1));
    block.compute(frame);
    EXPECT_FALSE(block.thick[5] > 0);
    EXPECT_GT(block.height[0][5], 0);
    block.correct(5, frame);
    for (const auto& row : block.height) {
        EXPECT_EQ(row[5], -std::numeric_limits<double>::infinity());
    }
}

/// The sum of the heights on both sides certifies the facets that one height leaves open.
TEST(Suspects, AreFewOfADelaunayTriangulation) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (const int n : {100, 3000}) {
        SCOPED_TRACE(n);
        const PeriodicDelaunay delaunay =
            periodic_delaunay(Sites(cube, uniform_points(cube, n, 4)));
        const Suspects suspects = evaluated(delaunay).suspects;
        EXPECT_LE(suspects.facets.size(), std::size_t(delaunay.tetrahedra.n_facets()) / 5000);
        EXPECT_TRUE(suspects.tetrahedra.empty());
    }
}

/// A pass that ran before, on more or on fewer sites, leaves nothing in the next.
TEST(Energy, APassKeepsNothingOfTheOneBefore) {
    const Lattice cube = Lattice::box(1, 1, 1);
    EnergySums pass;
    Workers workers(1);
    for (const int n : {300, 9000, 10, 3000}) {
        SCOPED_TRACE(n);
        const PeriodicDelaunay delaunay =
            periodic_delaunay(Sites(cube, uniform_points(cube, n, 5)));
        const Evaluated fresh = evaluated(delaunay);
        Energy energy;
        const Suspects suspects =
            pass.run(delaunay.tetrahedra, delaunay.sites.coordinates(),
                     Frame(delaunay.sites.reduction().reduced, 1), workers, energy);
        EXPECT_EQ(energy.value, fresh.energy.value);
        EXPECT_EQ(energy.gradient, fresh.energy.gradient);
        EXPECT_EQ(energy.mass, fresh.energy.mass);
        EXPECT_EQ(suspects.facets, fresh.suspects.facets);
    }
}

}  // namespace
}  // namespace pcvt::space
