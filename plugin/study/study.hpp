#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plugin/study/study_table.hpp"

namespace pcvt {

/// The description of many runs on the unit square or cube: for each number of sites the runs 0, 1,
/// ..., run r from the random start of seed + r.
///
///   const Study study{.name = "fig11", .sites = {8, 9}, .runs = 100};
///   const std::optional<StudyTable> runs = run_study(study, {}, n_threads, {});
///   const StudyResult result = conclude_study(study, *runs);
struct Study {
    /// The name of a recipe.
    std::string name;
    /// Numbers of sites, each once.
    std::vector<int> sites;
    int runs = 1;
    std::uint64_t seed = 0;
};

/// Part `index` of `count`, counted from 1: the runs whose index in the order (sites, run) is
/// index - 1 modulo count.
struct StudyShard {
    int index = 1;
    int count = 1;
};

struct StudyPicture {
    /// Precedes the extension of its file; empty for the main picture.
    std::string suffix;
    std::string svg;
    /// The values of a plot, as plot_points() returns them; else empty.
    std::string points = {};
};

/// The tables and pictures of a study.
///
/// Its lists, and those of plots, grow element by element: where a later element of a nested braced
/// list throws, GCC 12 destroys the earlier ones twice.
struct StudyResult {
    /// The main table first, the runs themselves last.
    std::vector<StudyTable> tables;
    std::vector<StudyPicture> pictures;
};

/// One kind of study: a row of `study_recipes()`.
struct StudyRecipe {
    std::string name;
    /// One line for the help.
    std::string description;
    /// The study with default options.
    Study standard;
    int most_sites;
    /// The domain of the random sites, and the options of `pcvt mesh` that a run needs besides
    /// --sites and --seed.
    std::string domain = "on the unit square";
    std::string options = {};
    /// Whether it measures times, and so makes one run at a time.
    bool timed;
    /// Columns of a run's rows, after n, run and seed.
    std::vector<std::string> columns;
    /// Notes on the meaning of the columns.
    std::vector<std::string> notes;
    /// Suffixes of the tables and pictures that `conclude` returns.
    std::vector<std::string> tables;
    std::vector<std::string> pictures;
    /// How many columns of the main table are printed.
    std::size_t printed_columns;
    /// The rows of one run, which depend only on n and the seed, except for times.
    std::vector<StudyRow> (*run)(int n, int run, std::uint64_t seed);
    /// Tables and pictures from the rows of all runs.
    StudyResult (*conclude)(const Study& study, const StudyTable& runs);
};

/// table1, fig7, ... fig11, sizes, symmetry, gersho3d, sizes3d.
const std::vector<StudyRecipe>& study_recipes();

/// @throws InvalidInput naming the known recipes.
const StudyRecipe& find_study_recipe(const std::string& name);

/// The progress of a study.
struct StudyProgress {
    int runs_done = 0;
    int n_runs = 0;
    /// The sites in the runs done over the sites in all runs: about the share of the time.
    double share = 0;
};

/// Called now and then on the calling thread; false cancels.
using StudyCallback = std::function<bool(const StudyProgress&)>;

/// Computes the runs of a shard. The rows do not depend on the number of threads, except for times.
/// @returns the table of the runs; `nullopt` if the callback cancelled.
/// @throws InvalidInput, LimitExceeded for a study or shard that cannot be computed.
std::optional<StudyTable> run_study(const Study& study, StudyShard shard, int n_threads,
                                    const StudyCallback& callback);

/// A study and its runs, read back.
struct MergedStudy {
    Study study;
    StudyTable runs;
};

/// One table of runs with the name of its file.
struct NamedRuns {
    std::string file;
    StudyTable table;
};

/// Merges the shards of one study, in any order, into the table of the unsplit study.
/// @throws BadFile       a file holds no runs, the files belong to different studies or versions,
/// or
///                       two files hold the same run.
/// @throws InvalidInput  a shard is missing.
MergedStudy merge_runs(const std::vector<NamedRuns>& parts);

/// The tables, including that of the runs, and the pictures.
StudyResult conclude_study(const Study& study, const StudyTable& runs);

}  // namespace pcvt
