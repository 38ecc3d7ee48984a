#include "plugin/study/study.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <utility>

#include "io/forms/tile_file.hpp"
#include "mesher/base/error.hpp"
#include "plugin/study/study_files.hpp"
#include "plugin/study/study_pictures.hpp"
#include "plugin/study/study_recipes.hpp"
#include "tests/support/lattices.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

const Study kSmall{"fig11", {4, 5, 11}, 7, 3};

StudyTable all_runs(const Study& study, StudyShard shard = {}, int n_threads = 1) {
    return run_study(study, shard, n_threads, {}).value();
}

std::string bytes(const StudyResult& result) {
    std::string all;
    for (const StudyTable& table : result.tables) all += encode_csv(table);
    for (const StudyPicture& picture : result.pictures) all += picture.svg;
    return all;
}

/// Returns the shards of a study, encoded to CSV and decoded again.
std::vector<NamedRuns> shards(const Study& study, int count) {
    std::vector<NamedRuns> parts;
    for (int k = 1; k <= count; ++k) {
        const std::string name = "part" + std::to_string(k);
        parts.push_back({name, decode_csv(name, encode_csv(all_runs(study, {k, count})))});
    }
    return parts;
}

std::string complaint(const std::vector<NamedRuns>& parts) {
    try {
        merge_runs(parts);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "none";
}

TEST(Study, MergedShardsGiveTheBytesOfTheUnsplitStudy) {
    const std::string unsplit = bytes(conclude_study(kSmall, all_runs(kSmall)));
    for (const int count : {1, 2, 5, 40}) {
        std::vector<NamedRuns> parts = shards(kSmall, count);
        std::reverse(parts.begin(), parts.end());
        const MergedStudy merged = merge_runs(parts);
        EXPECT_EQ(bytes(conclude_study(merged.study, merged.runs)), unsplit) << count;
    }
}

TEST(Study, TheNumberOfThreadsChangesNoByte) {
    EXPECT_EQ(encode_csv(all_runs(kSmall, {}, 1)), encode_csv(all_runs(kSmall, {}, 3)));
}

TEST(Study, EveryRecipeConcludesFromASmallStudy) {
    for (const StudyRecipe& recipe : study_recipes()) {
        const Study study{recipe.name, {5, 12}, 2, 1};
        const StudyTable runs = all_runs(study);
        const StudyResult result = conclude_study(study, runs);
        EXPECT_EQ(result.tables.size(), recipe.tables.size() + 1) << recipe.name;
        EXPECT_EQ(result.pictures.size(), recipe.pictures.size()) << recipe.name;
        for (const StudyPicture& picture : result.pictures) {
            EXPECT_THAT(picture.svg, HasSubstr("</svg>"));
        }
        if (recipe.timed) continue;
        const MergedStudy merged = merge_runs(shards(study, 2));
        EXPECT_EQ(encode_csv(merged.runs), encode_csv(runs)) << recipe.name;
    }
}

TEST(Study, AllRunsOfSixSitesAreLattices) {
    const StudyResult result =
        conclude_study({"fig11", {6, 5}, 20, 0}, all_runs({"fig11", {6, 5}, 20, 0}));
    const StudyTable& shares = result.tables[0];
    EXPECT_EQ(shares.number(shares.rows[0], "percent"), 100);
    EXPECT_EQ(shares.number(shares.rows[0], "lattices"), 20);
    EXPECT_NEAR(shares.number(shares.rows[0], "best_energy"), 1.0 / 36, 1e-9);
    EXPECT_EQ(shares.number(shares.rows[1], "percent"), 0);
    const StudyTable& patterns = result.tables[1];
    ASSERT_EQ(patterns.rows.size(), 1u);
    EXPECT_EQ(patterns.number(patterns.rows[0], "count"), 20);
}

// A residual of 1e-8 distinguishes lattices from other arrangements.
TEST(Study, RunsOfFewSitesConvergeToTheirTolerance) {
    const StudyTable runs = all_runs({"fig11", {4, 5}, 10, 0});
    for (const StudyRow& row : runs.rows) {
        ASSERT_EQ(row[runs.column("stop")], "converged");
        EXPECT_LE(runs.number(row, "residual"), 1e-8);
    }
}

TEST(Study, TableOneHasThePapersNumbers) {
    const Study study{"table1", {3, 30}, 12, 0};
    const StudyTable table = conclude_study(study, all_runs(study)).tables[0];
    const double cvt[] = {6.6180e-2, 5.5454e-3};
    const double pcvt[] = {5.9671e-2, 5.3482e-3};
    const double hex[] = {5.3458e-2, 5.3458e-3};
    for (std::size_t k = 0; k < 2; ++k) {
        const StudyRow& row = table.rows[k];
        EXPECT_NEAR(table.number(row, "F_CVT") / cvt[k], 1, 0.02);
        EXPECT_NEAR(table.number(row, "F_PCVT") / pcvt[k], 1, 5e-5);
        EXPECT_NEAR(table.number(row, "F_hex") / hex[k], 1, 1e-5);
        EXPECT_THAT(row[table.column("reached_from")], HasSubstr("seed"));
    }
}

TEST(Study, EnergiesThatNoRandomStartReachesComeFromTheLattice) {
    const Study study{"table1", {100}, 1, 0};
    const StudyTable table = conclude_study(study, all_runs(study)).tables[0];
    EXPECT_EQ(table.rows[0][table.column("reached_from")], "lattice start");
    EXPECT_EQ(table.number(table.rows[0], "F_PCVT"), table.number(table.rows[0], "F_lattice"));
}

TEST(Study, CancellingGivesNothing) {
    EXPECT_FALSE(run_study(kSmall, {}, 1, [](const StudyProgress&) { return false; }));
    double last = -1;
    run_study(kSmall, {}, 1, [&](const StudyProgress& progress) {
        EXPECT_GE(progress.share, last);
        last = progress.share;
        return true;
    });
    EXPECT_EQ(last, 1);
}

TEST(Study, MergingNamesTheFault) {
    std::vector<NamedRuns> parts = shards(kSmall, 3);
    EXPECT_EQ(complaint(parts), "none");
    EXPECT_THAT(complaint({parts[0], parts[2]}), HasSubstr("run 1 of 4 sites is in no file"));
    EXPECT_THAT(complaint({parts[0], parts[1], parts[2], parts[1]}),
                HasSubstr("part2: run 1 of 4 sites is in another file too"));
    const std::vector<NamedRuns> others = shards({"fig11", {4, 5, 11}, 7, 4}, 3);
    EXPECT_THAT(complaint({parts[0], others[1], parts[2]}), HasSubstr("part2: another study"));
    NamedRuns foreign{"x", {}};
    EXPECT_THAT(complaint({foreign}), HasSubstr("x: holds no runs"));
    foreign.table.notes = {"pcvt 0.0.1: study fig11 --sites 4 --runs 7 --seed 0"};
    EXPECT_THAT(complaint({foreign}), HasSubstr("another version"));
}

TEST(Study, DamagedRunsAreRefusedBeforeTheyAreUsed) {
    NamedRuns whole{"whole", all_runs(kSmall)};
    StudyTable& table = whole.table;
    std::string& seed = table.rows[1][table.column("seed")];
    for (const char* damaged : {"x", "", "-1", "99999999999999999999999"}) {
        const std::string before = std::exchange(seed, damaged);
        EXPECT_THAT(complaint({whole}), HasSubstr("not that of the study; ")) << damaged;
        seed = before;
    }
    // A million runs, of which the file holds seven.
    std::string& note = table.notes[0];
    const std::size_t runs = note.find("--runs ");
    ASSERT_NE(runs, std::string::npos);
    note.insert(runs + 7, "100000");
    EXPECT_THAT(complaint({whole}), HasSubstr(" is in no file"));
}

TEST(Study, BadStudiesAreRefused) {
    const auto run = [](const Study& study, StudyShard shard) {
        return run_study(study, shard, 1, {});
    };
    EXPECT_THROW(run({"fig12", {4}, 1, 0}, {}), InvalidInput);
    EXPECT_THROW(run({"fig11", {}, 1, 0}, {}), InvalidInput);
    EXPECT_THROW(run({"fig11", {0}, 1, 0}, {}), InvalidInput);
    EXPECT_THROW(run({"fig11", {4, 4}, 1, 0}, {}), InvalidInput);
    EXPECT_THROW(run({"fig11", {4}, 0, 0}, {}), InvalidInput);
    EXPECT_THROW(run({"fig11", {4}, 1, 0}, {3, 2}), InvalidInput);
    EXPECT_THROW(run({"fig11", {1'000'000}, 1, 0}, {}), LimitExceeded);
}

TEST(StudyPictures, CellsFillTheDomainAndSitesLieInIt) {
    for (const auto& [name, lattice] : testing::lattices()) {
        for (const int n : {1, 2, 30}) {
            const plane::Points points = uniform_points(lattice, n, 4);
            const plane::CvtResult result = compute_cvt(lattice, points, plain_lbfgs(0, 0));
            for (const CellPanel& panel :
                 {periodic_panel(result), clipped_panel(lattice, points)}) {
                double area = 0;
                for (const CellPanel::Cell& cell : panel.cells) {
                    area += std::abs(plane::polygon_area(cell.polygon));
                }
                EXPECT_NEAR(area / lattice.area(), 1, 1e-9) << name << " n = " << n;
                EXPECT_EQ(panel.sites.size(), static_cast<std::size_t>(n)) << name;
            }
        }
    }
}

TEST(StudyPictures, ASiteOnTheBorderIsDrawnOnBothSides) {
    const plane::CvtResult corner =
        compute_cvt(unit_square(), plane::Vec2(0, 0), plain_lbfgs(0, 0));
    EXPECT_EQ(periodic_panel(corner).sites.size(), 4u);
    const plane::CvtResult side =
        compute_cvt(unit_square(), plane::Vec2(0.3, 1 - 1e-14), plain_lbfgs(0, 0));
    EXPECT_EQ(periodic_panel(side).sites.size(), 2u);
}

TEST(StudyFiles, OneNameYieldsAllTablesOrPictures) {
    const auto paths = [](const std::vector<std::string>& outputs, StudyShard shard) {
        std::vector<std::string> found;
        for (const StudyFile& file : plan_study_files(outputs, "fig11", shard, {})) {
            found.push_back(file.path);
        }
        return found;
    };
    EXPECT_THAT(paths({"a.csv"}, {}),
                ::testing::ElementsAre("a.csv", "a-patterns.csv", "a-runs.csv"));
    EXPECT_THAT(paths({"a.svg"}, {}), ::testing::ElementsAre("a.svg", "a-shares.svg"));
    EXPECT_THAT(paths({"r/"}, {}),
                ::testing::ElementsAre("r/fig11.csv", "r/fig11-patterns.csv", "r/fig11-runs.csv",
                                       "r/fig11.svg", "r/fig11-shares.svg", "r/fig11.html"));
    EXPECT_THAT(paths({"a.csv", "r/"}, {2, 4}),
                ::testing::ElementsAre("a.csv", "r/fig11-shard-2-of-4.csv"));
    EXPECT_THROW(paths({"a.svg"}, {2, 4}), InvalidInput);
    EXPECT_THROW(paths({"a.txt"}, {}), InvalidInput);
    EXPECT_THROW(paths({"a.csv", "./a.csv"}, {}), InvalidInput);
    EXPECT_THROW(plan_study_files({"a.csv"}, "fig11", {}, {"a-runs.csv"}), InvalidInput);
    EXPECT_THROW(plan_study_files({"a.svg"}, "table1", {}, {}), InvalidInput);
}

TEST(StudyTable, CsvReadsBackAndNamesTheLineOfAFault) {
    const StudyTable table{"", {"note"}, {}, {"a", "b"}, {{"1", ""}, {"x y", "2.5"}}};
    const StudyTable again = decode_csv("t", encode_csv(table));
    EXPECT_EQ(again.notes, table.notes);
    EXPECT_EQ(again.columns, table.columns);
    EXPECT_EQ(again.rows, table.rows);
    try {
        decode_csv("t", "# n\r\na,b\r\n1,2\r\n1,2,3\r\n");
        FAIL();
    } catch (const BadFile& error) {
        EXPECT_THAT(error.what(), HasSubstr("t:4: 3 cells under 2 columns"));
    }
    EXPECT_THROW(encode_csv({"", {}, {}, {"a"}, {{"1,2"}}}), InternalError);
}

TEST(Study, NumbersThatNoRunHasAreRefused) {
    const Study study{"fig10", {20, 30}, 1, 0};
    const StudyTable runs = all_runs(study);
    for (const char* number : {"1e300", "-1e101", "1e-300", "-5", "0"}) {
        StudyTable damaged = runs;
        damaged.rows.front()[damaged.column("mirrors")] = number;
        EXPECT_THROW(conclude_study(study, damaged), InvalidInput) << number;
    }
}

TEST(Study, SizesOfADamagedTableAreRefused) {
    for (const char* const name : {"sizes", "sizes3d"}) {
        const Study study{name, {5}, 2, 0};
        const StudyTable runs = all_runs(study);
        EXPECT_NO_THROW(conclude_study(study, runs));
        for (const char* column : {"wanted", "reached"}) {
            for (const char* count : {"0", "-1", "1e300"}) {
                StudyTable damaged = runs;
                for (StudyRow& row : damaged.rows) row[damaged.column(column)] = count;
                EXPECT_THROW(conclude_study(study, damaged), InvalidInput)
                    << column << " " << count;
            }
        }
    }
}

TEST(Study, EnergiesByIterationNeedBothMethods) {
    const Study study{"fig9", {5}, 1, 0};
    const StudyTable runs = all_runs(study);
    EXPECT_NO_THROW(conclude_study(study, runs));
    for (const char* method : {"standard", "periodic"}) {
        StudyTable damaged = runs;
        std::erase_if(damaged.rows,
                      [&](const StudyRow& row) { return row[damaged.column("method")] == method; });
        EXPECT_THROW(conclude_study(study, damaged), InvalidInput) << method;
    }
}

}  // namespace
}  // namespace pcvt
