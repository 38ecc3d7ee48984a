#include "mesher/space/cvt/cvt.hpp"

#include <gtest/gtest.h>

#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

using testing::Cubic;

double closed_form(Cubic kind, int n) {
    const double g = kind == Cubic::kSimple        ? 1.0 / 12
                     : kind == Cubic::kFaceCentred ? std::pow(2.0, -11.0 / 3)
                                                   : 19.0 / (192.0 * std::cbrt(2.0));
    return 3 * g / std::pow(n, 2.0 / 3);
}

Points with_noise(Points points, double size, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-size, size);
    for (double& x : points.reshaped()) x += uniform(random);
    return points;
}

TEST(SpaceCvt, CubicLatticesReturnFromNoise) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const auto expect = [&](Cubic kind, int m) {
        const Points exact = testing::cubic_points(kind, m);
        const auto n = int(exact.cols());
        SCOPED_TRACE(n);
        const double noise = 0.05 / std::cbrt(n);
        const auto result = compute_cvt(cube, with_noise(exact, noise, 1), {{.tolerance = 1e-8}});
        EXPECT_EQ(result.run.stop, Stop::kConverged);
        EXPECT_NEAR(result.run.energy / closed_form(kind, n), 1, 1e-12);
    };
    for (const int m : {1, 2, 3}) expect(Cubic::kBodyCentred, m);
    for (const int m : {1, 2}) expect(Cubic::kFaceCentred, m);
}

TEST(SpaceCvt, RandomStartsEndNearTheBodyCentredLattice) {
    const Lattice cube = Lattice::box(1, 1, 1);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const auto result =
            compute_cvt(cube, uniform_points(cube, 250, seed), {{.tolerance = 1e-4}});
        EXPECT_EQ(result.run.stop, Stop::kConverged);
        const double ratio = result.run.energy / body_centred_energy(1, 250);
        EXPECT_GT(ratio, 1 - 1e-12);
        EXPECT_LT(ratio, 1.012);
        testing::expect_torus(result.delaunay.tetrahedra, result.delaunay.sites.coordinates());
        testing::expect_delaunay(result.delaunay.tetrahedra, result.delaunay.sites.coordinates(),
                                 gram_of(result.delaunay.sites.reduction().reduced));
    }
}

TEST(SpaceCvt, LloydNeverIncreasesTheEnergy) {
    const Lattice lattice({1, 0, 0}, {0.3, 1, 0}, {0.1, 0.2, 1.3});
    double last = std::numeric_limits<double>::infinity();
    CvtOptions options{{.solver = Solver::kLloyd, .max_iterations = 30}};
    options.run.progress = [&](const Progress& progress) {
        EXPECT_LE(progress.value, last * (1 + 1e-14));
        last = progress.value;
        return true;
    };
    const auto result = compute_cvt(lattice, uniform_points(lattice, 40, 1), options);
    EXPECT_EQ(result.run.stop, Stop::kIterationLimit);
    EXPECT_EQ(result.run.iterations, 30);
}

TEST(SpaceCvt, CancelsAndKeepsAllSites) {
    const Lattice cube = Lattice::box(1, 1, 1);
    CvtOptions options;
    options.run.progress = [](const Progress& progress) { return progress.iteration < 3; };
    const auto result = compute_cvt(cube, uniform_points(cube, 30, 1), options);
    EXPECT_EQ(result.run.stop, Stop::kCancelled);
    testing::expect_torus(result.delaunay.tetrahedra, result.delaunay.sites.coordinates());
}

TEST(SpaceCvt, FewSitesOnAllLatticesConverge) {
    for (const auto& [name, lattice] : testing::space_lattices()) {
        for (const int n : {1, 2, 3, 7}) {
            SCOPED_TRACE(name + " with " + std::to_string(n));
            const auto result = compute_cvt(lattice, uniform_points(lattice, n, 1), {});
            EXPECT_EQ(result.run.stop, Stop::kConverged);
            EXPECT_GT(result.run.energy, body_centred_energy(lattice.volume(), n) * (1 - 1e-12));
        }
    }
}

TEST(SpaceCvt, ThreadsChangeNoBit) {
    const Lattice cube = Lattice::box(1, 1, 1);
    const Points points = uniform_points(cube, 300, 1);
    const auto one = compute_cvt(cube, points, {{.max_iterations = 5, .n_threads = 1}});
    const auto two = compute_cvt(cube, points, {{.max_iterations = 5, .n_threads = 2}});
    EXPECT_EQ(one.delaunay.sites.coordinates(), two.delaunay.sites.coordinates());
    EXPECT_EQ(one.run.energy, two.run.energy);
}

}  // namespace
}  // namespace pcvt::space
