#include "mesher/plane/search/global_search.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "mesher/base/error.hpp"
#include "tests/support/example_lattices.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt::plane {
namespace {

using testing::kSquare;

SearchResult search(const Lattice& period, int n, int budget, int n_threads = 1) {
    return search_minimum(period, n, 0, {.run = {.n_threads = n_threads}, .budget = budget});
}

/// Law (1), and the reported energy is the energy of the sites.
TEST(GlobalSearch, IsNeverAboveTheBestLattice) {
    CvtOptions as_given;
    as_given.run.max_iterations = 0;
    for (const auto& [name, period] : testing::lattices()) {
        for (const int n : {1, 2, 7, 40}) {
            const SearchResult result = search(period, n, 600);
            EXPECT_LE(result.energy, best_lattice(period, n).energy) << name << n;
            const CvtResult there = compute_cvt(period, result.points, as_given);
            EXPECT_NEAR(there.run.energy / result.energy, 1, 1e-11) << name << n;
            EXPECT_LT(there.run.residual, 2e-9) << name << n;
        }
    }
}

/// Law (2).
TEST(GlobalSearch, DoesNotDependOnTheNumberOfThreads) {
    const SearchResult one = search(kSquare, 44, 2500);
    for (const int n_threads : {3, 16}) {
        const SearchResult other = search(kSquare, 44, 2500, n_threads);
        EXPECT_EQ(one.points, other.points);
        EXPECT_EQ(one.found, other.found);
        EXPECT_EQ(one.starts, other.starts);
        EXPECT_EQ(one.evaluations, other.evaluations);
    }
}

/// For these numbers of sites, states below the best lattice are known.
TEST(GlobalSearch, FindsStatesBelowTheBestLattice) {
    for (const int n : {7, 10, 13, 17, 19, 21, 22, 26, 27, 29, 31}) {
        const SearchResult result = search(kSquare, n, 1500);
        EXPECT_LT(result.energy, result.lattice.energy * (1 - 1e-3)) << n << result.found;
    }
}

TEST(GlobalSearch, ReturnsTheLatticeWhereNoLowerStateExists) {
    for (const int n : {4, 8, 15, 30, 56}) {
        const SearchResult result = search(kSquare, n, 1500);
        EXPECT_EQ(result.points, pattern_points(best_lattice(kSquare, n)));
        EXPECT_EQ(result.found, "lattice of " + std::to_string(n));
    }
}

TEST(GlobalSearch, SpendsItsBudgetAndLittleMore) {
    for (const int budget : {400, 1000, 5000}) {
        const SearchResult result = search(kSquare, 30, budget);
        EXPECT_GE(result.evaluations, budget);
        EXPECT_LE(result.evaluations, budget + 8 * 30);
    }
}

TEST(GlobalSearch, ReturnsTheLatticeWhereTheBudgetAllowsNoStart) {
    const SearchResult result = search(kSquare, 10, 399);
    EXPECT_EQ(result.starts, 0);
    EXPECT_EQ(result.energy, best_lattice(kSquare, 10).energy);
}

TEST(GlobalSearch, CanBeCancelledAtAnyCall) {
    for (const int last : {1, 2, 40}) {
        int calls = 0;
        SearchOptions options{.run = {.n_threads = 3}, .budget = 100'000};
        options.run.progress = [&](const Progress& progress) {
            EXPECT_EQ(progress.budget, 100'000);
            return ++calls < last;
        };
        EXPECT_TRUE(search_minimum(kSquare, 30, 0, options).cancelled);
        EXPECT_EQ(calls, last);
    }
}

TEST(GlobalSearch, CallsBackOnTheCallingThread) {
    SearchOptions options{.run = {.n_threads = 4}, .budget = 3000};
    options.run.progress = [caller = std::this_thread::get_id()](const Progress&) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        return true;
    };
    search_minimum(kSquare, 30, 0, options);
}

TEST(GlobalSearch, RefusesNoSites) { EXPECT_THROW(search(kSquare, 0, 1), InvalidInput); }

TEST(DefaultBudget, RisesAndFallsWithTheNumberOfSites) {
    EXPECT_EQ(default_search_budget(7), 14'000);
    EXPECT_EQ(default_search_budget(100), 200'000);
    EXPECT_EQ(default_search_budget(400), 200'000);
    EXPECT_EQ(default_search_budget(4'000), 20'000);
    EXPECT_EQ(default_search_budget(1 << 28), 0);
}

/// Uses the default budget, as the command line does.
TEST(SlowGlobalSearch, FindsStatesBelowTheBestLatticeForOverAHundredSites) {
    for (const int n : {119, 197}) {
        const SearchResult result = search(kSquare, n, default_search_budget(n), 2);
        EXPECT_LT(result.energy, result.lattice.energy * (1 - 5e-3)) << n;
    }
}

}  // namespace
}  // namespace pcvt::plane
