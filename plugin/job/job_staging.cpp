#include "plugin/job/job_staging.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <mutex>

#include "io/bytes/output_error.hpp"
#include "mesher/base/workers.hpp"

namespace pcvt {
namespace {

/// The progress of the files of a job, which several threads write.
class FileProgress {
   public:
    FileProgress(const std::vector<JobFile>& files, JobMonitor& monitor)
        : files_(files), state_(files.size(), kWaiting), monitor_(monitor) {
        if (!files.empty()) monitor_.begin(Phase::kWriting, words(0));
    }

    void begin(std::size_t file) { set(file, kOpen); }
    void end(std::size_t file) { set(file, kDone); }
    /// Adds a share of the work on one file.
    void add(double share) {
        const std::lock_guard lock(mutex_);
        done_ += share / double(files_.size());
        monitor_.advance(done_);
    }

   private:
    enum State : char { kWaiting, kOpen, kDone };

    std::string words(std::size_t file) const {
        const std::string name = std::filesystem::path(files_[file].path()).filename().string();
        return "writing " + name + ", " + std::to_string(file + 1) + " of " +
               std::to_string(files_.size());
    }
    /// The words name the first open file.
    void set(std::size_t file, State state) {
        const std::lock_guard lock(mutex_);
        state_[file] = state;
        const auto open = std::find(state_.begin(), state_.end(), kOpen);
        const auto first = static_cast<std::size_t>(open - state_.begin());
        if (open == state_.end() || first == shown_) return;
        shown_ = first;
        monitor_.describe(words(first));
    }

    const std::vector<JobFile>& files_;
    std::vector<State> state_;
    JobMonitor& monitor_;
    std::mutex mutex_;
    std::size_t shown_ = 0;
    double done_ = 0;
};

/// About the shares of the steps in the time of a file.
constexpr double kEncoding = 0.35;
constexpr double kStaging = 0.1;
constexpr double kProving = 1 - kEncoding - kStaging;

/// Encodes a file, proves its bytes and lets them reach the disk under a hidden name, where they
/// are compared. A file that is refused reaches no disk.
void stage_file(const FileContent& content, const JobFile& file, FileProgress& progress,
                OutputSet& outputs) {
    const std::vector<EncodedFile> encoded = content.encode(file);
    progress.add(kEncoding);
    content.prove(file, encoded);
    progress.add(kProving);
    outputs.stage_and_compare(encoded);
    progress.add(kStaging);
}

}  // namespace

std::vector<std::string> stage_files(const Job& job, const std::vector<JobFile>& files,
                                     const FileContent& content, JobMonitor& monitor,
                                     OutputSet& outputs) {
    // Before all files, so that a file inside of a case folder is staged in that folder.
    for (const JobFile& file : files) {
        if (!file.folder.empty()) outputs.stage_folder(file.folder);
    }
    FileProgress progress(files, monitor);
    std::vector<std::exception_ptr> faults(files.size());
    std::vector<std::string> refused(files.size());
    // The largest file of space takes most of the memory of a run.
    const int n_at_once = job.is_in_space() ? 1 : job.run.n_threads;
    Workers workers(std::min(n_at_once, static_cast<int>(files.size())));
    workers.for_each(static_cast<int>(files.size()), [&](int k) {
        try {
            progress.begin(static_cast<std::size_t>(k));
            try {
                stage_file(content, files[k], progress, outputs);
            } catch (const CoarsePrecision& error) {
                refused[k] = error.what();
            }
            progress.end(static_cast<std::size_t>(k));
        } catch (...) {
            faults[k] = std::current_exception();
        }
    });
    for (const std::exception_ptr& fault : faults) {
        if (fault) std::rethrow_exception(fault);
    }
    return refused;
}

std::vector<std::string> wait_for_turn(OutputSet& outputs, JobMonitor& monitor) {
    return outputs.wait_for_turn([&monitor](const std::string& words) { monitor.describe(words); });
}

}  // namespace pcvt
