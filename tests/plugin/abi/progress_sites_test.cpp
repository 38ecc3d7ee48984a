#include <gmock/gmock.h>
#include <pcvt.h>

#include <cmath>
#include <string>
#include <vector>

namespace pcvt::abi {
namespace {

using ::testing::HasSubstr;

/// The sites that a progress callback gets.
struct Watch {
    bool is_asking = true;
    int n_views = 0;
    std::vector<double> last = {};

    static int look(const pcvt_progress* progress, void* data) {
        auto& watch = *static_cast<Watch*>(data);
        if (!watch.is_asking || progress->phase != PCVT_PHASE_OPTIMISE) return 0;
        pcvt_sites sites;
        if (pcvt_get_progress_sites(&sites, sizeof sites) != PCVT_OK) return 0;
        ++watch.n_views;
        watch.last.assign(sites.points, sites.points + 2 * std::size_t(sites.n_sites));
        return 0;
    }
};

pcvt_options oblique_options_for(int n_sites) {
    pcvt_options options;
    EXPECT_EQ(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION), PCVT_OK);
    options.n_sites = n_sites;
    options.lattice[2] = 0.3;
    options.lattice[3] = 0.9;
    options.origin[0] = 0.25;
    options.seed = 5;
    return options;
}

/// Runs and returns the sites of the result.
std::vector<double> sites_after_run(pcvt_options options, Watch& watch) {
    options.progress = Watch::look;
    options.progress_data = &watch;
    pcvt_result* result = nullptr;
    EXPECT_GE(pcvt_generate(&options, &result), 0) << pcvt_last_error();
    pcvt_sites sites;
    EXPECT_EQ(pcvt_get_sites(result, &sites, sizeof sites), PCVT_OK);
    std::vector<double> points(sites.points, sites.points + 2 * std::size_t(sites.n_sites));
    pcvt_free(result);
    return points;
}

/// Expects the sites of the last iteration to be those of the result, which does not depend on
/// whether a callback gets them.
void expect_sites_of_result(const pcvt_options& options) {
    Watch watch;
    Watch idle{.is_asking = false};
    const std::vector<double> points = sites_after_run(options, watch);
    EXPECT_GT(watch.n_views, 1);
    EXPECT_EQ(watch.last, points);
    EXPECT_EQ(sites_after_run(options, idle), points);
    EXPECT_EQ(idle.n_views, 0);
}

TEST(ProgressSites, EndAtTheResultWithEachSolverAndStart) {
    for (const int n : {2, 3, 8, 300}) {
        for (const int solver : {PCVT_SOLVER_LBFGS, PCVT_SOLVER_LLOYD, PCVT_SOLVER_NEWTON}) {
            pcvt_options options = oblique_options_for(n);
            options.solver = solver;
            options.max_iterations = 40;
            expect_sites_of_result(options);
        }
    }
    pcvt_options coarse = oblique_options_for(500);
    coarse.start = PCVT_START_COARSE;
    expect_sites_of_result(coarse);
}

TEST(ProgressSites, EndAtTheResultWithDensitiesAreasAndAnAspect) {
    pcvt_options density = oblique_options_for(200);
    density.density_source = "1 + u";
    pcvt_options areas = oblique_options_for(60);
    areas.area_law = "lognormal:0.3";
    pcvt_options steps = areas;
    steps.max_iterations = 3;
    pcvt_options aspect = oblique_options_for(200);
    aspect.aspect = 2;
    for (const pcvt_options& options : {density, areas, steps, aspect}) {
        expect_sites_of_result(options);
    }
}

TEST(ProgressSites, EndAtTheResultBetweenWallsAndWithASymmetry) {
    pcvt_options options = oblique_options_for(120);
    options.lattice[2] = 0;
    options.origin[0] = 0;
    options.symmetry = PCVT_SYMMETRY_PM;
    expect_sites_of_result(options);
    options.symmetry = PCVT_SYMMETRY_NONE;
    options.walls = PCVT_WALLS_XY;
    Watch watch;
    const std::vector<double> points = sites_after_run(options, watch);
    ASSERT_EQ(watch.last.size(), points.size());
    for (std::size_t k = 0; k < points.size(); ++k) EXPECT_NEAR(watch.last[k], points[k], 1e-14);
}

TEST(ProgressSites, AreRefusedOutsideOfACallbackAndWhereTheyAreNotKnown) {
    pcvt_sites sites;
    EXPECT_EQ(pcvt_get_progress_sites(&sites, sizeof sites), PCVT_ERROR_ARGUMENT);
    EXPECT_THAT(pcvt_last_error(), HasSubstr("no progress callback runs"));
    pcvt_options space = oblique_options_for(20);
    const pcvt_options flat = space;
    EXPECT_EQ(pcvt_options_init(&space, sizeof space, PCVT_ABI_VERSION), PCVT_OK);
    space.n_sites = flat.n_sites;
    space.dimension = 3;
    static std::string refusal;
    space.progress = [](const pcvt_progress*, void*) -> int {
        pcvt_sites unknown;
        if (pcvt_get_progress_sites(&unknown, sizeof unknown) == PCVT_OK) return 1;
        refusal = pcvt_last_error();
        return 0;
    };
    pcvt_result* result = nullptr;
    EXPECT_EQ(pcvt_generate(&space, &result), PCVT_OK);
    EXPECT_THAT(refusal, HasSubstr("not known in this call"));
    pcvt_free(result);
    EXPECT_EQ(pcvt_get_progress_sites(&sites, sizeof sites), PCVT_ERROR_ARGUMENT);
}

TEST(ProgressSites, AreThoseOfTheInnerRunInACallbackThatStartsOne) {
    static std::vector<int> counts;
    counts.clear();
    pcvt_options options = oblique_options_for(30);
    options.max_iterations = 1;
    options.progress = [](const pcvt_progress*, void*) -> int {
        Watch watch;
        pcvt_options inner = oblique_options_for(7);
        inner.max_iterations = 1;
        sites_after_run(inner, watch);
        counts.push_back(static_cast<int>(watch.last.size()) / 2);
        pcvt_sites sites;
        if (pcvt_get_progress_sites(&sites, sizeof sites) == PCVT_OK)
            counts.push_back(sites.n_sites);
        return 0;
    };
    pcvt_result* result = nullptr;
    EXPECT_EQ(pcvt_generate(&options, &result), PCVT_NOT_CONVERGED);
    pcvt_free(result);
    EXPECT_THAT(counts, ::testing::Contains(30));
    EXPECT_THAT(counts, ::testing::Contains(7));
}

}  // namespace
}  // namespace pcvt::abi
