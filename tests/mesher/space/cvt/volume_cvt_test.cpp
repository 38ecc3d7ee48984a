#include "mesher/space/cvt/volume_cvt.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "tests/support/case_count.hpp"
#include "tests/support/random_space_sites.hpp"
#include "tests/support/space_cells.hpp"
#include "tests/support/space_lattices.hpp"
#include "tests/support/space_laws.hpp"
#include "tests/support/space_power_mirrors.hpp"
#include "tests/support/space_weights.hpp"

namespace pcvt::space {
namespace {

double largest_error(const VolumeCvtResult& result) {
    return ((result.cell_volumes - result.targets).array() / result.targets.array())
        .abs()
        .maxCoeff();
}

/// The volumes of a random case: equal, lognormal to S = 0.8, or of two sizes.
Eigen::VectorXd random_volumes(const Sites& sites, std::mt19937_64& random) {
    const int n = sites.n_sites();
    const double total = sites.lattice().volume();
    const int kind = testing::random_integer(random, 0, 4);
    if (kind == 0) return Eigen::VectorXd::Constant(n, total / n);
    if (kind < 4) {
        return testing::lognormal_volumes(n, 0.8 * testing::random_number(random), total, random);
    }
    Eigen::VectorXd volumes(n);
    for (double& v : volumes) v = testing::random_integer(random, 0, 4) == 0 ? 1000.0 : 1.0;
    return volumes * (total / volumes.sum());
}

/// Sites of random_space_sites(), at times with pairs at 1e-6 h.
Sites random_sites(std::mt19937_64& random, std::string& name) {
    auto [kind, sites] = testing::random_space_sites(random);
    name = kind;
    if (sites.n_sites() < 2 || testing::random_integer(random, 0, 4) != 0) return sites;
    name += ", with pairs";
    const Points positions = sites.positions();
    Points points = positions;
    for (Eigen::Index s = 0; s + 1 < points.cols(); s += 4) {
        const Vec3 way(testing::random_number(random), 1, testing::random_number(random));
        points.col(s + 1) = points.col(s) + 1e-6 * sites.spacing() * way;
    }
    return {sites.lattice(), points};
}

/// Whether positions of sites are exact, or the sites so generic that rounding decides nothing.
bool has_exact_mirrors(const std::string& name) {
    const auto has = [&](const char* words) { return name.find(words) != std::string::npos; };
    const bool oblique = has("oblique") || has("unreduced") || has("left-handed");
    return has("in a cube") || (oblique && has("random sites") && !has("pairs"));
}

/// The counts of a campaign.
struct Campaign {
    int n_cases = 0;
    int n_mirrors = 0;
    int n_polyhedra = 0;
    int n_rounding = 0;
    /// In mean volumes: where rounding does not limit the error, and where it does.
    double largest_error = 0;
    double largest_rounding = 0;
};

/// Expects law 1, and that cells of few sites are those of other methods.
void expect_volumes(const Sites& sites, const std::string& name, const VolumeCvtResult& result,
                    Campaign& campaign) {
    ++campaign.n_cases;
    ASSERT_TRUE(result.volumes.converged) << result.volumes.largest_relative_error;
    const double mean = sites.lattice().volume() / sites.n_sites();
    const double of_mean = (result.cell_volumes - result.targets).cwiseAbs().maxCoeff() / mean;
    // The volume of an unreduced lattice has a rounding of its own.
    ASSERT_NEAR(of_mean, result.largest_error, 1e-10);
    const bool by_rounding = std::min(result.largest_error, largest_error(result)) > 1.01e-10;
    if (by_rounding) {
        ASSERT_LE(result.volumes.largest_relative_error, result.volumes.rounding);
    }
    double& largest = by_rounding ? campaign.largest_rounding : campaign.largest_error;
    largest = std::max(largest, result.largest_error);
    campaign.n_rounding += by_rounding ? 1 : 0;
    const PeriodicDelaunay& regular = result.delaunay;
    const Eigen::VectorXd& weights = regular.weights;
    ASSERT_NEAR(weights.sum(), 0, 1e-12 * weights.cwiseAbs().maxCoeff() * sites.n_sites());
    testing::expect_torus(regular.tetrahedra, regular.sites.coordinates());
    // Where many sites are cospherical, exact numbers make the mirrors slow.
    const int most_mirrored = name.find("random sites") != std::string::npos ? 60 : 12;
    if (has_exact_mirrors(name) && sites.n_sites() <= most_mirrored) {
        ++campaign.n_mirrors;
        const auto mirrors = testing::space_power_mirrors(regular.sites, weights);
        ASSERT_TRUE(mirrors.hidden.empty());
        ASSERT_TRUE(testing::canonical_tetrahedra(regular.tetrahedra) == mirrors.tetrahedra);
    }
    // Clipping is not exact enough where the planes between two sites are as long as 1e8 distances.
    if (sites.n_sites() <= 12 && name.find("pairs") == std::string::npos) {
        ++campaign.n_polyhedra;
        const auto cells = testing::brute_force_energy(regular.sites, weights);
        for (SiteId s = 0; s < sites.n_sites(); ++s) {
            ASSERT_NEAR(cells.volumes[s], result.targets[s], 1e-9 * sites.lattice().volume());
        }
    }
}

// Law 1 on all kinds of lattices and sites. PCVT_VOLUME_CASES=20000 in the environment runs as many
// cases, PCVT_VOLUME_SEED begins elsewhere.
TEST(VolumeCvt, SlowReachesVolumesOnRandomInputs) {
    const int n_cases = testing::case_count("PCVT_VOLUME_CASES", 150);
    const int seed = testing::case_count("PCVT_VOLUME_SEED", 1);
    Campaign campaign;
    for (int k = 0; k < n_cases; ++k) {
        std::seed_seq words{seed, k};
        std::mt19937_64 random(words);
        std::string name;
        const Sites sites = random_sites(random, name);
        SCOPED_TRACE("case " + std::to_string(k) + ": " + name);
        const Eigen::VectorXd volumes = random_volumes(sites, random);
        try {
            const VolumeCvtResult result =
                compute_volume_cvt(sites.lattice(), sites.positions(), {.volumes = volumes});
            expect_volumes(sites, name, result, campaign);
        } catch (const DuplicateSites&) {
            // Sites 2^-50 of a period apart.
        }
        if (HasFailure()) return;
    }
    std::cout << campaign.n_cases << " cases of " << n_cases << " from seed " << seed << ", "
              << campaign.n_mirrors << " with mirrors, " << campaign.n_polyhedra
              << " with polyhedra, " << campaign.n_rounding
              << " above 1e-10 of the mean by rounding (at most " << campaign.largest_rounding
              << "); largest error of the others " << campaign.largest_error << "\n";
    EXPECT_GE(campaign.n_cases, n_cases / 2);
    EXPECT_GE(campaign.n_mirrors, n_cases / 50);
}

// Law 2.
TEST(VolumeCvt, EqualVolumesOnALatticeGiveEqualWeights) {
    for (const testing::Cubic kind :
         {testing::Cubic::kSimple, testing::Cubic::kBodyCentred, testing::Cubic::kFaceCentred}) {
        const Points points = testing::cubic_points(kind, 3);
        const auto n = points.cols();
        const VolumeCvtResult result = compute_volume_cvt(
            testing::kCube, points, {.volumes = Eigen::VectorXd::Constant(n, 1.0 / double(n))});
        EXPECT_EQ(result.volumes.newton_steps, 0);
        EXPECT_EQ(result.delaunay.weights, Eigen::VectorXd::Zero(n));
        EXPECT_EQ(result.run.stop, Stop::kConverged);
    }
}

VolumeCvtResult grains(int n, int n_threads, int n_steps, bool by_rank = true) {
    std::mt19937_64 random(1);
    return compute_volume_cvt(testing::kCube, uniform_points(testing::kCube, n, 1),
                              {.volumes = testing::lognormal_volumes(n, 0.35, 1, random),
                               .by_rank = by_rank,
                               .run = {.max_iterations = n_steps, .n_threads = n_threads}});
}

// Law 3, with several slabs of tetrahedra.
TEST(VolumeCvt, SlowEveryBitIsTheSameForAnyNumberOfThreads) {
    const VolumeCvtResult one = grains(16'000, 1, 1);
    const VolumeCvtResult three = grains(16'000, 3, 1);
    EXPECT_TRUE(one.volumes.converged);
    EXPECT_EQ(one.delaunay.sites.coordinates(), three.delaunay.sites.coordinates());
    EXPECT_EQ(one.delaunay.weights, three.delaunay.weights);
    EXPECT_EQ(one.cell_volumes, three.cell_volumes);
    EXPECT_EQ(one.run.energy, three.run.energy);
    EXPECT_TRUE(testing::canonical_tetrahedra(one.delaunay.tetrahedra) ==
                testing::canonical_tetrahedra(three.delaunay.tetrahedra));
}

// Law 4.
TEST(VolumeCvt, GivesVolumesByRank) {
    const int n = 40;
    std::mt19937_64 random(2);
    const Points points = uniform_points(testing::kCube, n, 3);
    const Eigen::VectorXd volumes = testing::lognormal_volumes(n, 0.5, 1, random);
    const VolumeCvtResult result =
        compute_volume_cvt(testing::kCube, points, {.volumes = volumes, .by_rank = true});
    EXPECT_THAT(std::vector<double>(result.targets.begin(), result.targets.end()),
                ::testing::UnorderedElementsAreArray(volumes.begin(), volumes.end()));
    const auto cells = testing::brute_force_energy(Sites(testing::kCube, points)).volumes;
    for (int s = 0; s < n; ++s) {
        for (int t = 0; t < n; ++t) {
            ASSERT_TRUE(!(cells[s] < cells[t]) || result.targets[s] <= result.targets[t]);
        }
    }
}

// Five bold steps keep the volumes and lower residuals and energy.
TEST(VolumeCvt, BoldStepsMakeCellsRounder) {
    std::vector<double> residuals;
    const int n = 1000;
    std::mt19937_64 random(1);
    const VolumeCvtResult result =
        compute_volume_cvt(testing::kCube, uniform_points(testing::kCube, n, 1),
                           {.volumes = testing::lognormal_volumes(n, 0.35, 1, random),
                            .by_rank = true,
                            .run = {.max_iterations = 5, .progress = [&](const Progress& now) {
                                        residuals.push_back(now.rms_residual);
                                        return true;
                                    }}});
    EXPECT_TRUE(result.volumes.converged);
    EXPECT_LE(largest_error(result), 1.01e-10);
    EXPECT_EQ(result.run.iterations, 5);
    EXPECT_EQ(result.run.stop, Stop::kIterationLimit);
    ASSERT_EQ(residuals.size(), 6u);
    EXPECT_LT(residuals[5], residuals[0] / 4);
    EXPECT_NEAR(residuals[5], result.run.rms_residual, 0);
    EXPECT_LT(result.run.energy, grains(n, 1, 0).run.energy);
}

TEST(VolumeCvt, EndsAtTheToleranceWhereNoLimitIsGiven) {
    const int n = 8;
    std::mt19937_64 random(5);
    const VolumeCvtResult result =
        compute_volume_cvt(testing::kCube, uniform_points(testing::kCube, n, 1),
                           {.volumes = testing::lognormal_volumes(n, 0.2, 1, random),
                            .run = {.tolerance = 1e-3, .max_iterations = -1}});
    EXPECT_EQ(result.run.stop, Stop::kConverged);
    EXPECT_LE(result.run.residual, 1e-3);
    EXPECT_GT(result.run.iterations, 5);
}

TEST(VolumeCvt, IsCancelledByTheCallback) {
    std::mt19937_64 random(1);
    const VolumeCvtResult result = compute_volume_cvt(
        testing::kCube, uniform_points(testing::kCube, 100, 1),
        {.volumes = testing::lognormal_volumes(100, 0.35, 1, random),
         .run = {.max_iterations = 5,
                 .progress = [](const Progress& now) { return now.iteration < 2; }}});
    EXPECT_EQ(result.run.stop, Stop::kCancelled);
    EXPECT_EQ(result.run.iterations, 2);
}

TEST(VolumeCvt, RefusesVolumesInOneLine) {
    const Points points = uniform_points(testing::kCube, 3, 1);
    const auto fault = [&](const Eigen::VectorXd& volumes) -> std::string {
        try {
            compute_volume_cvt(testing::kCube, points, {.volumes = volumes});
        } catch (const InvalidInput& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(fault(Eigen::Vector2d(0.5, 0.5)),
              "there are 2 volumes for 3 sites; give one for each site");
    EXPECT_EQ(fault(Eigen::Vector3d(0.5, 0, 0.5)),
              "the volume of site 1 is not a positive finite number; correct it");
    EXPECT_EQ(fault(Eigen::Vector3d(0.5, 0.5, 0.5)),
              "the volumes do not sum to the volume of the domain; scale them to this sum");
}

}  // namespace
}  // namespace pcvt::space
