#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plugin/study/study_table.hpp"

namespace pcvt {

/// Many runs on the unit square, as a plain description: for each number of sites runs 0, 1, ...,
/// run r from the random start of seed + r.
struct Study {
    /// That of a recipe.
    std::string name;
    /// Numbers of sites, each once.
    std::vector<int> sites;
    int runs = 1;
    std::uint64_t seed = 0;
};

/// Part `index` of `count`, from 1: the runs whose place in the order (sites, run) is index - 1
/// modulo count.
struct StudyShard {
    int index = 1;
    int count = 1;
};

struct StudyPicture {
    /// What precedes the extension of its file; empty for the main picture.
    std::string suffix;
    std::string svg;
};

/// What a study concludes from its runs.
struct StudyResult {
    /// The main table first, the runs themselves last.
    std::vector<StudyTable> tables;
    std::vector<StudyPicture> pictures;
};

/// How one kind of study is done: a row of `study_recipes()`.
struct StudyRecipe {
    std::string name;
    /// One line for the help.
    std::string description;
    /// What is run where nothing else is asked for.
    Study standard;
    int most_sites;
    /// Its times mean something only while nothing else runs: one run at a time.
    bool timed;
    /// SpatialSort of a run's rows, behind n, run and seed.
    std::vector<std::string> columns;
    /// What they mean.
    std::vector<std::string> notes;
    /// Suffixes of the tables and pictures that `conclude` gives.
    std::vector<std::string> tables;
    std::vector<std::string> pictures;
    /// How many columns of the main table are printed.
    std::size_t printed_columns;
    /// One run: its rows, a function of n and the seed alone but for times.
    std::vector<StudyRow> (*run)(int n, int run, std::uint64_t seed);
    /// Tables and pictures from the rows of all runs.
    StudyResult (*conclude)(const Study& study, const StudyTable& runs);
};

/// table1, fig7, ... fig11.
const std::vector<StudyRecipe>& study_recipes();

/// @throws InvalidInput naming the recipes that there are.
const StudyRecipe& find_study_recipe(const std::string& name);

/// How far a study is.
struct StudyProgress {
    int runs_done = 0;
    int n_runs = 0;
    /// Sites in the runs done, over those in all runs: about the share of the time.
    double share = 0;
};

/// Called now and then on the calling thread; false cancels.
using StudyCallback = std::function<bool(const StudyProgress&)>;

/// Does the runs of a shard; the rows are the same for every number of threads, but for times.
/// @returns the table of the runs, nothing if the callback cancelled.
/// @throws InvalidInput, LimitExceeded where the study or the shard cannot be done.
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

/// Puts the shards of one study together, in whatever order they come: the table is that of the
/// unsplit run.
/// @throws BadFile where a file holds no runs, the files belong to different studies or versions,
///         or a run stands in two files; InvalidInput where a shard is missing.
MergedStudy merge_runs(const std::vector<NamedRuns>& parts);

/// The tables, the runs among them, and the pictures.
StudyResult conclude_study(const Study& study, const StudyTable& runs);

}  // namespace pcvt
