#include "plugin/cli/study_command.hpp"

#include <csignal>
#include <cstdio>

#include "io/bytes/input_file.hpp"
#include "io/forms/tile_file.hpp"
#include "io/outputs/recovery.hpp"
#include "io/outputs/writable_paths.hpp"
#include "mesher/base/checkpoint.hpp"
#include "plugin/cli/terminal/cancel_signal.hpp"
#include "plugin/cli/terminal/console.hpp"
#include "plugin/cli/terminal/status_line.hpp"
#include "plugin/study/study_files.hpp"

namespace pcvt::cli {
namespace {

/// Ends the work of every thread once a signal is noted.
class UntilSignal final : public Client {
   public:
    void pass() override {
        if (cancel_signal() != 0) throw Cancelled{};
    }
};

/// The share of the work after which the time left is shown.
constexpr double kLeastShare = 0.02;

std::vector<std::string> progress_parts(const StudyProgress& progress, double seconds) {
    std::vector<std::string> parts{std::to_string(progress.runs_done) + " of " +
                                   std::to_string(progress.n_runs) + " runs"};
    if (progress.share < kLeastShare) return parts;
    const double left = seconds * (1 - progress.share) / progress.share;
    parts.push_back(duration_in_words(left) + " left");
    return parts;
}

std::optional<StudyTable> run_watched(const StudyRequest& request, bool quiet) {
    StatusLine line(!quiet);
    catch_cancel_signals();
    return run_study(request.study, request.shard, request.n_threads,
                     [&line](const StudyProgress& progress) {
                         if (line.due()) line.draw(progress_parts(progress, line.seconds()));
                         return cancel_signal() == 0;
                     });
}

/// @param name  of the study, which the files must be of.
MergedStudy merge_files(const std::string& name, const std::vector<std::string>& files) {
    std::vector<NamedRuns> parts;
    for (const std::string& file : files) {
        parts.push_back({file, decode_csv(file, read_whole_file(file, kTableInput))});
    }
    MergedStudy merged = merge_runs(parts);
    if (merged.study.name != name) {
        throw BadFile(files[0] + ": runs of " + merged.study.name + ", not of " + name +
                      "; name that study");
    }
    return merged;
}

ExitCode cancelled() {
    std::fputs("pcvt: cancelled; nothing was written\n", stderr);
    return cancel_signal() == SIGTERM ? ExitCode::kTerminated : ExitCode::kInterrupted;
}

void print_recovered(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) std::fprintf(stderr, "pcvt: %s\n", line.c_str());
}

/// Returns one line for each set of files that was recovered.
std::vector<std::string> write_files(const MergedStudy& done, const StudyResult& result,
                                     const std::vector<StudyFile>& files,
                                     const StudyOptions& options) {
    StatusLine line(!options.quiet);
    catch_cancel_signals();
    return write_study(done.study, result, files, options.force,
                       [&line](const auto& words) { line.draw({words}); });
}

ExitCode run_to_the_end(const StudyRequest& request, const StudyOptions& options) {
    const StudyRecipe& recipe = find_study_recipe(request.study.name);
    const std::vector<StudyFile> files =
        plan_study_files(options.outputs, recipe.name, request.shard, options.merge);
    std::vector<std::string> paths;
    for (const StudyFile& file : files) paths.push_back(file.path);
    if (!options.quiet) print_recovered(recover_unfinished(paths));
    for (const std::string& path : paths) require_writable(path, options.force);
    if (request.shard.count > 1 && files.empty()) {
        throw InvalidInput("--shard makes a file of runs; give -o FILE.csv");
    }

    MergedStudy done{request.study, {}};
    if (options.merge.empty()) {
        std::optional<StudyTable> runs = run_watched(request, options.quiet);
        if (!runs) return cancelled();
        done.runs = std::move(*runs);
    } else {
        done = merge_files(request.study.name, options.merge);
    }
    const bool is_part = request.shard.count > 1;
    const StudyResult result =
        is_part ? StudyResult{{done.runs}, {}} : conclude_study(done.study, done.runs);
    const std::vector<std::string> recovered = write_files(done, result, files, options);
    if (!options.quiet) print_recovered(recovered);
    if (!options.quiet && !is_part) {
        const auto text = [&] {
            return aligned_text(result.tables.front(), recipe.printed_columns);
        };
        if (files.empty()) {
            print(text());
        } else {
            print_after_files(text);
        }
    }
    return ExitCode::kDone;
}

}  // namespace

ExitCode run_study_command(const StudyRequest& request, const StudyOptions& options) {
    UntilSignal until_signal;
    const ClientScope scope(&until_signal);
    try {
        return run_to_the_end(request, options);
    } catch (const Cancelled&) {
        return cancelled();
    }
}

}  // namespace pcvt::cli
