#include "mesher/space/delaunay/tetrahedra_flips.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "mesher/space/energy/energy.hpp"
#include "tests/support/space_families.hpp"
#include "tests/support/space_laws.hpp"

namespace pcvt::space {
namespace {

/// Sites that moved so little that no tetrahedron is inverted: the largest of some noises.
Points moved_a_little(const PeriodicDelaunay& delaunay, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Points noise(3, delaunay.sites.n_sites());
    for (double& x : noise.reshaped()) x = uniform(random);
    for (double size = 0.1;; size /= 2) {
        Points moved = delaunay.sites.coordinates() + size * noise;
        for (double& x : moved.reshaped()) x = std::nearbyint(x * kGrid) / kGrid;
        bool positive = true;
        for (int t = 0; t < delaunay.tetrahedra.n_tetrahedra(); ++t) {
            positive = positive && is_positive(delaunay.tetrahedra, moved, t);
        }
        if (positive) return moved;
    }
}

/// After flips the triangulation is that of a new build; where flips get stuck, it still fills the
/// torus.
TEST(TetrahedraFlips, SlowRestoreTheTriangulation) {
    int n_restored = 0;
    int n_stuck = 0;
    std::int64_t n_flips = 0;
    for (const auto& [name, sites] : testing::space_site_families(12)) {
        SCOPED_TRACE(name);
        PeriodicDelaunay delaunay = periodic_delaunay(sites);
        const Points moved = moved_a_little(delaunay, 13);
        const Gram gram = gram_of(sites.reduction().reduced);
        TetrahedraFlips flips(delaunay.tetrahedra, moved, gram);
        std::vector<int> all(static_cast<std::size_t>(delaunay.tetrahedra.n_facets()));
        std::iota(all.begin(), all.end(), 0);
        const bool restored = flips.flip(all);
        n_flips += flips.n_flips();
        testing::expect_torus(delaunay.tetrahedra, moved);
        ++(restored ? n_restored : n_stuck);
        if (!restored) continue;
        testing::expect_delaunay(delaunay.tetrahedra, moved, gram);
    }
    EXPECT_GT(n_flips, 200);
    EXPECT_GT(n_restored, 10 * n_stuck);
    RecordProperty("restored", n_restored);
    RecordProperty("stuck", n_stuck);
}

/// The energy before the flips, corrected for them, is that of a pass after them.
TEST(TetrahedraFlips, SlowAllowToCorrectTheEnergy) {
    int n_corrected = 0;
    Workers workers(1);
    for (const auto& [name, sites] : testing::space_site_families(14)) {
        SCOPED_TRACE(name);
        PeriodicDelaunay delaunay = periodic_delaunay(sites);
        const Points moved = moved_a_little(delaunay, 15);
        const Frame frame(sites.reduction().reduced, sites.spacing());
        Energy corrected;
        const auto suspects =
            EnergySums().run(delaunay.tetrahedra, moved, frame, workers, corrected);
        const Gram gram = gram_of(sites.reduction().reduced);
        TetrahedraFlips flips(delaunay.tetrahedra, moved, gram);
        if (!flips.flip(suspects.facets) || flips.n_flips() == 0) continue;
        if (!correct_for_exchange(flips.take_exchanged(), moved, frame, corrected)) continue;
        ++n_corrected;
        Energy expected;
        EnergySums().run(delaunay.tetrahedra, moved, frame, workers, expected);
        EXPECT_NEAR(corrected.value, expected.value, 1e-13 * expected.value);
        const double cell = frame.volume() / sites.n_sites();
        EXPECT_LT((corrected.mass - expected.mass).cwiseAbs().maxCoeff(), 1e-12 * cell);
        EXPECT_LT((corrected.gradient - expected.gradient).cwiseAbs().maxCoeff(), 1e-12 * cell);
    }
    EXPECT_GT(n_corrected, 10);
}

}  // namespace
}  // namespace pcvt::space
