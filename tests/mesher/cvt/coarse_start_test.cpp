#include "mesher/cvt/coarse_start.hpp"

#include <gtest/gtest.h>

#include "mesher/density/density_survey.hpp"
#include "mesher/mesh/valence.hpp"
#include "tests/support/densities.hpp"

namespace pcvt {
namespace {

CoarseStartOptions seeded(std::uint64_t seed, int n_threads = 1) {
    return {.seed = seed, .n_threads = n_threads, .density = {}, .progress = {}};
}

/// The fraction of the cells of a result whose valence is not six.
double defects(const CvtResult& result) {
    const TorusTriangulation& t = result.delaunay.triangulation();
    std::vector<int> valence(static_cast<std::size_t>(t.n_sites()));
    for (int h = 0; h < t.n_halfedges(); ++h) ++valence[t.corner(h).site];
    return 1 - double(std::count(valence.begin(), valence.end(), 6)) / t.n_sites();
}

TEST(CoarseStart, ReturnsTheRequestedNumberOfDistinctSites) {
    const Lattice lattice({2, 0}, {0.5, 1});
    for (const int n : {1, 2, 3, 16, 17, 63, 64, 65, 255, 256, 257, 1000}) {
        const Points points = coarse_start(lattice, n, seeded(1));
        ASSERT_EQ(points.cols(), n);
        const Sites sites(lattice, points);
        EXPECT_LT(sites.duplicates().first, 0);
    }
}

TEST(CoarseStart, DependsOnTheSeedAndNotOnTheThreads) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    const Points points = coarse_start(lattice, 40000, seeded(1));
    EXPECT_EQ(points, coarse_start(lattice, 40000, seeded(1, 2)));
    EXPECT_NE(points, coarse_start(lattice, 40000, seeded(2)));
}

TEST(CoarseStart, LeadsToLowerMinimaWithFewerDefects) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    CvtOptions options;
    options.tolerance = 1e-4;
    const CvtResult from_random = compute_cvt(lattice, uniform_points(lattice, 4000, 1), options);
    const CvtResult from_coarse =
        compute_cvt(lattice, coarse_start(lattice, 4000, seeded(1)), options);
    EXPECT_LT(from_coarse.run.energy, from_random.run.energy * (1 - 1e-3));
    EXPECT_LT(defects(from_coarse), 0.04);
    EXPECT_GT(defects(from_random), 0.07);
}

TEST(CoarseStart, LeadsToLowerMinimaOfSmoothDensitiesToo) {
    const Lattice lattice = Lattice::rectangle(1, 1);
    CvtOptions options;
    options.density = testing::ridge_density();
    options.tolerance = 1e-3;
    CoarseStartOptions coarse = seeded(1);
    coarse.density = options.density;
    const CvtResult from_random =
        compute_cvt(lattice, graded_points(lattice, *options.density, 4000, 1), options);
    const CvtResult from_coarse =
        compute_cvt(lattice, coarse_start(lattice, 4000, coarse), options);
    EXPECT_LT(from_coarse.run.energy, from_random.run.energy * (1 - 1e-3));
    EXPECT_LT(from_coarse.run.evaluations, from_random.run.evaluations);
    EXPECT_LT(from_coarse.density->spacing_deviation, 0.02);
}

TEST(CoarseStart, StopsWhenCancelled) {
    CoarseStartOptions options = seeded(1);
    int n_calls = 0;
    options.progress = [&](const Progress&) { return ++n_calls < 5; };
    EXPECT_EQ(coarse_start(Lattice::rectangle(1, 1), 1000, options).cols(), 0);
    EXPECT_EQ(n_calls, 5);
}

}  // namespace
}  // namespace pcvt
