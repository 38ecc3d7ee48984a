#include "plugin/study/study.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <map>
#include <new>
#include <set>
#include <thread>

#include "io/bytes/nearest_word.hpp"
#include "io/bytes/text.hpp"
#include "mesher/base/error.hpp"
#include "mesher/base/workers.hpp"
#include "plugin/job/version.hpp"
#include "plugin/study/study_recipes.hpp"

namespace pcvt {
namespace {

/// Runs of each thread between two sortings of their rows into the table.
constexpr int kRunsPerChunk = 8;
constexpr const char* kRunsSuffix = "-runs";

/// One run of a study.
struct StudyTask {
    int n;
    int run;
    friend constexpr auto operator<=>(const StudyTask&, const StudyTask&) = default;
};

/// Calls visit(task) for each run, in the order of the table.
template <class Visit>
void for_each_task(const Study& study, const Visit& visit) {
    for (const int n : study.sites) {
        for (int run = 0; run < study.runs; ++run) visit(StudyTask{n, run});
    }
}

std::vector<StudyTask> all_tasks(const Study& study) {
    std::vector<StudyTask> tasks;
    for_each_task(study, [&](StudyTask task) { tasks.push_back(task); });
    return tasks;
}

void check_study(const Study& study, StudyShard shard) {
    const StudyRecipe& recipe = find_study_recipe(study.name);
    if (study.sites.empty()) throw InvalidInput("no number of sites; give at least one");
    if (study.runs < 1) throw InvalidInput("the number of runs is below 1; take 1");
    std::set<int> seen;
    for (const int n : study.sites) {
        const std::string number = std::to_string(n);
        if (n < 1) throw InvalidInput(number + " sites: too few; give at least 1");
        if (n > recipe.most_sites) {
            throw LimitExceeded(number + " sites: too many for study " + study.name +
                                "; give at most " + std::to_string(recipe.most_sites));
        }
        if (!seen.insert(n).second) {
            throw InvalidInput(number + " sites are given twice; remove one");
        }
    }
    if (static_cast<double>(study.sites.size()) * study.runs > std::numeric_limits<int>::max()) {
        throw LimitExceeded("more than 2^31 runs; take fewer");
    }
    if (shard.count < 1 || shard.index < 1 || shard.index > shard.count) {
        throw InvalidInput("there is no shard " + std::to_string(shard.index) + " of " +
                           std::to_string(shard.count) + "; take 1/1");
    }
}

/// The line that identifies a study: "study fig11 --sites 4,6 --runs 5000 --seed 0".
std::string study_line(const Study& study) {
    std::string line = "study " + study.name + " --sites ";
    for (std::size_t k = 0; k < study.sites.size(); ++k) {
        line += (k == 0 ? "" : ",") + std::to_string(study.sites[k]);
    }
    return line + " --runs " + std::to_string(study.runs) + " --seed " + std::to_string(study.seed);
}

/// From this number of sites on, `pcvt mesh` starts otherwise than at random by default.
constexpr int kFewestForCoarseStart = 1000;

std::vector<std::string> head_notes(const Study& study) {
    const StudyRecipe& recipe = find_study_recipe(study.name);
    std::string options = recipe.options;
    if (std::any_of(study.sites.begin(), study.sites.end(),
                    [](int n) { return n >= kFewestForCoarseStart; })) {
        options += " --start random";
    }
    return {std::string("pcvt ") + version() + ": " + study_line(study),
            "run r starts from the random sites of seed " + std::to_string(study.seed) + " + r " +
                recipe.domain + " (pcvt mesh --sites n --seed s" + options + ")"};
}

StudyTable empty_runs(const Study& study) {
    const StudyRecipe& recipe = find_study_recipe(study.name);
    StudyTable table{.suffix = kRunsSuffix,
                     .notes = head_notes(study),
                     .remarks = {},
                     .columns = {"n", "run", "seed"},
                     .rows = {}};
    table.notes.insert(table.notes.end(), recipe.notes.begin(), recipe.notes.end());
    table.columns.insert(table.columns.end(), recipe.columns.begin(), recipe.columns.end());
    return table;
}

std::vector<StudyRow> rows_of_run(const StudyRecipe& recipe, const Study& study, StudyTask task) {
    const std::uint64_t seed = study.seed + static_cast<std::uint64_t>(task.run);
    std::vector<StudyRow> rows = recipe.run(task.n, task.run, seed);
    for (StudyRow& row : rows) {
        row.insert(row.begin(),
                   {std::to_string(task.n), std::to_string(task.run), std::to_string(seed)});
    }
    return rows;
}

/// Counts the runs that several threads have done and reports them on the calling thread.
class StudyMonitor {
   public:
    StudyMonitor(const std::vector<StudyTask>& tasks, const StudyCallback& callback)
        : callback_(callback), n_runs_(static_cast<int>(tasks.size())) {
        for (const StudyTask& task : tasks) n_sites_ += task.n;
    }

    bool is_cancelled() const { return cancelled_; }
    void note(const StudyTask& done) {
        ++runs_done_;
        sites_done_ += done.n;
        if (std::this_thread::get_id() == caller_) report();
    }
    void report() {
        if (!callback_ || cancelled_) return;
        const double share = n_sites_ > 0 ? double(sites_done_) / double(n_sites_) : 1;
        if (!callback_({runs_done_, n_runs_, share})) cancelled_ = true;
    }

   private:
    const StudyCallback& callback_;
    std::thread::id caller_ = std::this_thread::get_id();
    int n_runs_;
    std::int64_t n_sites_ = 0;
    std::atomic<int> runs_done_ = 0;
    std::atomic<std::int64_t> sites_done_ = 0;
    std::atomic<bool> cancelled_ = false;
};

/// Reads the description back from the first note of a table.
Study parse_study(const std::string& file, const StudyTable& table) {
    const std::string head = std::string("pcvt ") + version() + ": study ";
    if (table.notes.empty() || !table.notes[0].starts_with("pcvt ")) {
        throw BadFile(file + ": holds no runs of a study; give files of pcvt study --shard");
    }
    if (!table.notes[0].starts_with(head)) {
        throw BadFile(file + ": written by another version (" + table.notes[0] +
                      "); make it again with this one");
    }
    try {
        LineScanner scanner(file, table.notes[0]);
        scanner.next();
        const auto& words = scanner.words();
        Study study;
        study.name = words.at(3);
        std::string_view rest = words.at(5);
        while (!rest.empty()) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            study.sites.push_back(parse_integer(rest.substr(0, comma)));
            rest.remove_prefix(std::min(comma + 1, rest.size()));
        }
        study.runs = parse_integer(words.at(7));
        study.seed = std::stoull(std::string(words.at(9)));
        check_study(study, {});
        return study;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        throw BadFile(file +
                      ": its first line describes no study; give files of pcvt study --shard");
    }
}

StudyTask task_of(const std::string& file, const StudyTable& table, const StudyRow& row) {
    try {
        return {parse_integer(row[table.column("n")]), parse_integer(row[table.column("run")])};
    } catch (const InvalidInput& error) {
        throw BadFile(file + ": " + error.what());
    }
}

std::string in_words(StudyTask task) {
    return "run " + std::to_string(task.run) + " of " + std::to_string(task.n) + " sites";
}

/// The rows of each run; all rows of a run come from one file.
using RowsByRun = std::map<StudyTask, std::vector<StudyRow>>;

void collect(const NamedRuns& part, std::uint64_t seed, RowsByRun& rows) {
    std::set<StudyTask> own;
    for (const StudyRow& row : part.table.rows) {
        const StudyTask task = task_of(part.file, part.table, row);
        const std::string& stated = row[part.table.column("seed")];
        if (stated != std::to_string(seed + static_cast<std::uint64_t>(task.run))) {
            throw BadFile(part.file + ": " + in_words(task) + " has the seed " + in_quotes(stated) +
                          ", not that of the study; the file is damaged, make it again");
        }
        if (own.insert(task).second && rows.contains(task)) {
            throw BadFile(part.file + ": " + in_words(task) +
                          " is in another file too; give each shard once");
        }
        rows[task].push_back(row);
    }
}

}  // namespace

const std::vector<StudyRecipe>& study_recipes() {
    static const std::vector<StudyRecipe> kRecipes{
        table1_recipe(), fig7_recipe(),  fig8_recipe(),     fig9_recipe(),     fig10_recipe(),
        fig11_recipe(),  sizes_recipe(), symmetry_recipe(), gersho3d_recipe(), sizes3d_recipe()};
    return kRecipes;
}

const StudyRecipe& find_study_recipe(const std::string& name) {
    std::string known;
    std::vector<std::string> names;
    for (const StudyRecipe& recipe : study_recipes()) {
        if (recipe.name == name) return recipe;
        known += " " + recipe.name;
        names.push_back(recipe.name);
    }
    const std::string meant = nearest_word(name, names);
    throw InvalidInput("study " + in_quotes(name) + ": unknown; " +
                       (meant.empty() ? "take one of" + known : "did you mean " + meant + "?"));
}

std::optional<StudyTable> run_study(const Study& study, StudyShard shard, int n_threads,
                                    const StudyCallback& callback) {
    check_study(study, shard);
    const StudyRecipe& recipe = find_study_recipe(study.name);
    std::vector<StudyTask> tasks;
    const std::vector<StudyTask> all = all_tasks(study);
    for (std::size_t k = shard.index - 1; k < all.size(); k += shard.count) tasks.push_back(all[k]);

    Workers workers(recipe.timed ? 1 : n_threads);
    const int n_tasks = static_cast<int>(tasks.size());
    const int chunk = kRunsPerChunk * workers.n_threads();
    StudyTable table = empty_runs(study);
    StudyMonitor monitor(tasks, callback);
    monitor.report();
    for (int begin = 0; begin < n_tasks && !monitor.is_cancelled(); begin += chunk) {
        std::vector<std::vector<StudyRow>> rows(
            static_cast<std::size_t>(std::min(chunk, n_tasks - begin)));
        workers.for_each(static_cast<int>(rows.size()), [&](int k) {
            if (monitor.is_cancelled()) return;
            rows[k] = rows_of_run(recipe, study, tasks[begin + k]);
            monitor.note(tasks[begin + k]);
        });
        for (std::vector<StudyRow>& part : rows) {
            std::move(part.begin(), part.end(), std::back_inserter(table.rows));
        }
    }
    monitor.report();
    if (monitor.is_cancelled()) return std::nullopt;
    return table;
}

MergedStudy merge_runs(const std::vector<NamedRuns>& parts) {
    if (parts.empty()) throw InvalidInput("no file to merge; give the files of all shards");
    const Study study = parse_study(parts[0].file, parts[0].table);
    MergedStudy merged{study, empty_runs(study)};
    RowsByRun rows;
    for (const NamedRuns& part : parts) {
        parse_study(part.file, part.table);
        if (part.table.notes[0] != parts[0].table.notes[0]) {
            throw BadFile(part.file + ": another study than " + parts[0].file + " (" +
                          part.table.notes[0] + "); merge shards of one study");
        }
        if (part.table.columns != merged.runs.columns) {
            throw BadFile(part.file +
                          ": not the columns of runs; give files of pcvt study --shard");
        }
        collect(part, study.seed, rows);
    }
    // Ends at the first missing run, however many runs a damaged file states.
    for_each_task(study, [&](StudyTask task) {
        const auto found = rows.find(task);
        if (found == rows.end()) {
            throw InvalidInput(in_words(task) + " is in no file; give the files of all shards");
        }
        std::move(found->second.begin(), found->second.end(), std::back_inserter(merged.runs.rows));
        rows.erase(found);
    });
    if (!rows.empty()) {
        throw InvalidInput(in_words(rows.begin()->first) +
                           " does not belong to the study; give files of pcvt study --shard");
    }
    return merged;
}

StudyResult conclude_study(const Study& study, const StudyTable& runs) {
    const StudyRecipe& recipe = find_study_recipe(study.name);
    StudyResult result = recipe.conclude(study, runs);
    if (result.tables.size() != recipe.tables.size() ||
        result.pictures.size() != recipe.pictures.size()) {
        throw InternalError("study " + study.name + " does not keep to its recipe");
    }
    for (std::size_t k = 0; k < result.tables.size(); ++k) {
        StudyTable& table = result.tables[k];
        table.suffix = recipe.tables[k];
        const std::vector<std::string> head = head_notes(study);
        table.notes.insert(table.notes.begin(), head.begin(), head.end());
    }
    for (std::size_t k = 0; k < result.pictures.size(); ++k) {
        result.pictures[k].suffix = recipe.pictures[k];
    }
    result.tables.push_back(runs);
    return result;
}

}  // namespace pcvt
