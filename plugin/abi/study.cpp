// pcvt_study(). The module for browsers does not contain this file.
#include <chrono>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/outputs/output_set.hpp"
#include "io/outputs/recovery.hpp"
#include "io/outputs/writable_paths.hpp"
#include "plugin/abi/guard.hpp"
#include "plugin/abi/host_progress.hpp"
#include "plugin/abi/option_values.hpp"
#include "plugin/abi/run_status.hpp"
#include "plugin/abi/views.hpp"
#include "plugin/pcvt.h"
#include "plugin/study/study_files.hpp"

namespace pcvt::abi {

using Texts = std::vector<const char*>;

/// A table with the pointers that C hosts see.
struct ListedTable {
    std::string name;
    Texts columns;
    Texts cells;
    Texts notes;
    std::size_t n_rows;
};

namespace {

void append_texts(const std::vector<std::string>& strings, Texts& texts) {
    for (const std::string& text : strings) texts.push_back(text.c_str());
}

/// @param table  must outlive the list.
ListedTable listed(const Study& study, const StudyTable& table) {
    ListedTable list{study.name + table.suffix, {}, {}, {}, table.rows.size()};
    append_texts(table.columns, list.columns);
    for (const StudyRow& row : table.rows) append_texts(row, list.cells);
    append_texts(table.notes, list.notes);
    append_texts(table.remarks, list.notes);
    return list;
}

std::int32_t length_of(std::size_t n) {
    if (n <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
        return static_cast<std::int32_t>(n);
    }
    throw LimitExceeded("a table of more than 2^31 rows; take fewer runs");
}

}  // namespace
}  // namespace pcvt::abi

// NOLINTNEXTLINE(readability-identifier-naming): the name that C knows.
struct pcvt_study_result {
    pcvt_study_result(const pcvt::Study& study, pcvt::StudyResult&& made)
        : content(std::move(made)),
          text(pcvt::aligned_text(content.tables.front(),
                                  pcvt::find_study_recipe(study.name).printed_columns)) {
        for (const pcvt::StudyTable& table : content.tables) {
            tables.push_back(pcvt::abi::listed(study, table));
        }
        for (const pcvt::StudyPicture& picture : content.pictures) {
            picture_names.push_back(study.name + picture.suffix);
        }
    }

    pcvt::StudyResult content;
    std::string text;
    std::vector<pcvt::abi::ListedTable> tables;
    std::vector<std::string> picture_names;
};

namespace pcvt::abi {
namespace {

pcvt_study_options standard_options(const char* name) {
    if (name == nullptr) throw InvalidInput("name is a null pointer");
    const StudyRecipe& recipe = find_study_recipe(name);
    pcvt_study_options options{};
    options.name = recipe.name.c_str();
    options.sites = recipe.standard.sites.data();
    options.n_sites = static_cast<std::int32_t>(recipe.standard.sites.size());
    options.runs = recipe.standard.runs;
    options.seed = recipe.standard.seed;
    return options;
}

Study study_of(const pcvt_study_options& options) {
    if (options.name == nullptr) throw InvalidInput("name is a null pointer");
    if (options.n_sites < 0 || (options.n_sites > 0 && options.sites == nullptr)) {
        throw InvalidInput("sites are n_sites numbers; give as many as n_sites says");
    }
    Study study{.name = find_study_recipe(options.name).name,
                .sites = {options.sites, options.sites + options.n_sites},
                .runs = options.runs,
                .seed = options.seed};
    return study;
}

/// Shows the runs done to a monitor, ten times a second at most and at the end, so that a slow
/// callback of the host does not hold up the runs.
class RunsShown {
   public:
    explicit RunsShown(JobMonitor& monitor) : monitor_(monitor) {}

    void show(const StudyProgress& progress) {
        const auto now = std::chrono::steady_clock::now();
        const bool is_last = progress.runs_done == progress.n_runs;
        if (!is_last && now - shown_ < std::chrono::milliseconds(100)) return;
        shown_ = now;
        monitor_.advance(progress.share);
        monitor_.describe(std::to_string(progress.runs_done) + " of " +
                          std::to_string(progress.n_runs) + " runs");
    }

   private:
    JobMonitor& monitor_;
    std::chrono::steady_clock::time_point shown_{};
};

/// Plans the files of a path, and requires that they can be written.
std::vector<StudyFile> planned_files(const pcvt_study_options& options, const Study& study) {
    if (options.path == nullptr) return {};
    if (*options.path == '\0') throw InvalidInput("path is empty; give a file or a folder");
    std::vector<StudyFile> files = plan_study_files({options.path}, study.name, {}, {});
    std::vector<std::string> paths;
    for (const StudyFile& file : files) paths.push_back(file.path);
    recover_unfinished(paths);
    for (const std::string& path : paths) require_writable(path, options.replace != 0);
    return files;
}

/// Makes the runs of a study, its conclusions and its files.
/// @throws Cancelled
std::unique_ptr<pcvt_study_result> made_study(const pcvt_study_options& options, const Study& study,
                                              JobMonitor& monitor) {
    const int n_threads = thread_count(options.n_threads);
    const std::vector<StudyFile> files = planned_files(options, study);
    std::unique_ptr<pcvt_study_result> made;
    OutputSet outputs;
    monitor.watch([&] {
        monitor.begin(Phase::kOptimising, "running " + study.name);
        RunsShown shown(monitor);
        const std::optional<StudyTable> runs =
            run_study(study, {}, n_threads, [&shown](const StudyProgress& progress) {
                shown.show(progress);
                return true;
            });
        made = std::make_unique<pcvt_study_result>(study, conclude_study(study, *runs));
        if (files.empty()) return;
        monitor.begin(Phase::kWriting, std::string("writing ") + options.path);
        stage_study(study, made->content, files, outputs);
        outputs.wait_for_turn([&](const std::string& words) { monitor.describe(words); });
    });
    // Nothing may fail after the files appear.
    const ClientScope no_client(nullptr);
    outputs.commit(options.replace != 0);
    return made;
}

pcvt_status run(const pcvt_study_options* given, pcvt_study_result** result,
                const std::fenv_t& host) {
    if (result == nullptr) throw InvalidInput("study is a null pointer");
    *result = nullptr;
    const pcvt_study_options options = read_struct("pcvt_study_options", given);
    const Study study = study_of(options);
    const JobCallback callback = job_callback({options.progress, options.progress_data},
                                              std::numeric_limits<double>::quiet_NaN(), host);
    const Job no_job;
    JobMonitor monitor(callback, no_job);
    try {
        *result = made_study(options, study, monitor).release();
        return PCVT_OK;
    } catch (const Cancelled&) {
        return cancelled_status();
    }
}

const pcvt_study_result& of(const pcvt_study_result* study) {
    if (study == nullptr) throw InvalidInput("study is a null pointer");
    return *study;
}

/// An element of a list of a study.
template <class List>
const auto& element(const List& list, std::int32_t k, const char* what) {
    if (k >= 0 && static_cast<std::size_t>(k) < list.size()) return list[k];
    throw InvalidInput("the study has " + std::to_string(list.size()) + " " + what + ", counted " +
                       "from 0; there is no " + std::to_string(k));
}

pcvt_table view_of(const ListedTable& table) {
    return {.name = table.name.c_str(),
            .columns = table.columns.data(),
            .cells = table.cells.data(),
            .notes = table.notes.data(),
            .n_columns = length_of(table.columns.size()),
            .n_rows = length_of(table.n_rows),
            .n_notes = length_of(table.notes.size()),
            .reserved = 0};
}

}  // namespace
}  // namespace pcvt::abi

using namespace pcvt::abi;

pcvt_status pcvt_study_options_init(pcvt_study_options* options, size_t struct_size,
                                    uint32_t abi_version, const char* name) {
    return give_defaults("pcvt_study_options", options, struct_size, abi_version,
                         [&] { return standard_options(name); });
}

pcvt_status pcvt_study(const pcvt_study_options* options, pcvt_study_result** study) {
    return guarded([&](const std::fenv_t& host) { return run(options, study, host); });
}

pcvt_status pcvt_get_study_contents(const pcvt_study_result* study, pcvt_study_contents* view,
                                    size_t view_size) {
    return give("pcvt_study_contents", view, view_size, [&]() -> pcvt_study_contents {
        return {.text = of(study).text.c_str(),
                .n_tables = length_of(study->tables.size()),
                .n_pictures = length_of(study->content.pictures.size())};
    });
}

pcvt_status pcvt_get_table(const pcvt_study_result* study, int32_t k, pcvt_table* view,
                           size_t view_size) {
    return give("pcvt_table", view, view_size,
                [&] { return view_of(element(of(study).tables, k, "tables")); });
}

pcvt_status pcvt_get_picture(const pcvt_study_result* study, int32_t k, pcvt_picture* view,
                             size_t view_size) {
    return give("pcvt_picture", view, view_size, [&]() -> pcvt_picture {
        const std::string& svg = element(of(study).content.pictures, k, "pictures").svg;
        return {.name = study->picture_names[k].c_str(), .svg = svg.c_str()};
    });
}

void pcvt_free_study(pcvt_study_result* study) { delete study; }
