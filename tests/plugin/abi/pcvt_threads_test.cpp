// Eight concurrent hosts: each generates a result, all request views of one common result, and all
// write the same files.
#include <gmock/gmock.h>
#include <pcvt.h>

#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace {

constexpr int kHosts = 8;

pcvt_result* short_run(int n_sites, std::uint64_t seed, int n_threads) {
    pcvt_options options;
    EXPECT_EQ(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION), PCVT_OK);
    options.n_sites = n_sites;
    options.seed = seed;
    options.n_threads = n_threads;
    options.max_iterations = 3;
    pcvt_result* result = nullptr;
    EXPECT_EQ(pcvt_generate(&options, &result), PCVT_NOT_CONVERGED);
    return result;
}

std::vector<double> sites_of(const pcvt_result* result) {
    pcvt_sites view;
    EXPECT_EQ(pcvt_get_sites(result, &view, sizeof view), PCVT_OK);
    return {view.points, view.points + 2 * view.n_sites};
}

template <class Task>
void on_all_hosts(const Task& task) {
    std::vector<std::thread> hosts;
    for (int k = 0; k < kHosts; ++k) hosts.emplace_back([&task, k] { task(k); });
    for (std::thread& host : hosts) host.join();
}

TEST(Threads, GenerateConcurrentlyTheResultsOfSingleRuns) {
    // With this many sites the library starts its own threads.
    constexpr int n_sites = 17000;
    std::vector<std::vector<double>> together(kHosts);
    on_all_hosts([&](int k) {
        pcvt_result* result = short_run(n_sites, static_cast<std::uint64_t>(k % 2), 2);
        together[k] = sites_of(result);
        pcvt_free(result);
    });
    for (int k = 0; k < kHosts; ++k) EXPECT_EQ(together[k], together[k % 2]) << k;
    EXPECT_NE(together[0], together[1]);
}

TEST(Threads, ShareTheViewsOfOneResult) {
    pcvt_result* result = short_run(300, 1, 1);
    std::vector<pcvt_tile> tiles(kHosts);
    std::vector<pcvt_statistics> figures(kHosts);
    on_all_hosts([&](int k) {
        pcvt_mesh mesh;
        EXPECT_EQ(pcvt_get_tile(result, PCVT_VORONOI, PCVT_WHOLE, &tiles[k], sizeof tiles[k]),
                  PCVT_OK);
        EXPECT_EQ(pcvt_get_mesh(result, PCVT_DELAUNAY, &mesh, sizeof mesh), PCVT_OK);
        EXPECT_EQ(pcvt_get_statistics(result, &figures[k], sizeof figures[k]), PCVT_OK);
    });
    for (int k = 0; k < kHosts; ++k) {
        EXPECT_EQ(tiles[k].points, tiles[0].points);
        EXPECT_EQ(figures[k].valences, figures[0].valences);
    }
    pcvt_free(result);
}

/// A result in three dimensions, and its tile.
struct SpaceRun {
    pcvt_result* result = nullptr;
    pcvt_cells cells = {};

    SpaceRun(int n_sites, std::uint64_t seed) {
        pcvt_options options;
        EXPECT_EQ(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION), PCVT_OK);
        options.dimension = 3;
        options.n_sites = n_sites;
        options.seed = seed;
        options.n_threads = 2;
        options.max_iterations = 3;
        EXPECT_EQ(pcvt_generate(&options, &result), PCVT_NOT_CONVERGED);
        EXPECT_EQ(pcvt_get_cells(result, &cells, sizeof cells), PCVT_OK);
    }
    ~SpaceRun() { pcvt_free(result); }
    SpaceRun(const SpaceRun&) = delete;
    SpaceRun& operator=(const SpaceRun&) = delete;

    std::vector<double> points() const {
        return {cells.points, cells.points + 3 * std::ptrdiff_t{cells.n_points}};
    }
};

TEST(Threads, GenerateConcurrentlyTheCellsOfSingleRuns) {
    constexpr int n_sites = 2000;
    std::vector<std::vector<double>> together(kHosts);
    on_all_hosts([&](int k) {
        together[k] = SpaceRun(n_sites, static_cast<std::uint64_t>(k % 2)).points();
    });
    for (int k = 0; k < 2; ++k) {
        EXPECT_EQ(together[k], SpaceRun(n_sites, static_cast<std::uint64_t>(k)).points());
    }
    for (int k = 0; k < kHosts; ++k) EXPECT_EQ(together[k], together[k % 2]) << k;
    EXPECT_NE(together[0], together[1]);
}

TEST(Threads, ShareTheCellsOfOneResult) {
    const SpaceRun run(300, 1);
    std::vector<pcvt_cells> cells(kHosts);
    std::vector<pcvt_statistics> figures(kHosts);
    on_all_hosts([&](int k) {
        EXPECT_EQ(pcvt_get_statistics(run.result, &figures[k], sizeof figures[k]), PCVT_OK);
        EXPECT_EQ(pcvt_get_cells(run.result, &cells[k], sizeof cells[k]), PCVT_OK);
    });
    for (int k = 0; k < kHosts; ++k) {
        EXPECT_EQ(cells[k].volumes, run.cells.volumes);
        EXPECT_EQ(figures[k].valences, figures[0].valences);
    }
}

pcvt_status write(const pcvt_result* result, const std::string& path, int32_t replace) {
    pcvt_write_options options = {};
    options.struct_size = sizeof options;
    options.kind = PCVT_DELAUNAY;
    options.replace = replace;
    return pcvt_write(result, path.c_str(), &options);
}

TEST(Threads, ReplaceTheSameFilesOneAfterTheOther) {
    std::vector<pcvt_result*> results;
    for (int k = 0; k < kHosts; ++k) results.push_back(short_run(30, std::uint64_t(k), 1));
    for (const char* name : {"a.obj", "new/a.obj", "a.foam"}) {
        const pcvt::testing::TemporaryFolder folder;
        std::vector<std::string> faults(kHosts);
        on_all_hosts([&](int k) {
            if (write(results[k], folder / name, 1) != PCVT_OK) faults[k] = pcvt_last_error();
        });
        EXPECT_EQ(faults, std::vector<std::string>(kHosts));
        const std::map<std::string, std::string> found = pcvt::testing::files_below(folder);
        int n_matching = 0;
        for (const pcvt_result* result : results) {
            EXPECT_EQ(write(result, folder / name, 1), PCVT_OK);
            n_matching += pcvt::testing::files_below(folder) == found ? 1 : 0;
        }
        EXPECT_EQ(n_matching, 1);
        EXPECT_EQ(write(results[0], folder / name, 0), PCVT_ERROR_IO);
        EXPECT_THAT(pcvt_last_error(), ::testing::EndsWith("it exists; set replace"));
    }
    for (pcvt_result* result : results) pcvt_free(result);
}

}  // namespace
