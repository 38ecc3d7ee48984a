#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/cvt/cvt.hpp"

namespace pcvt {

struct Job;

/// The parts of a run, in their order. A run leaves out the parts that it does not need.
enum class Phase { kStarting, kOptimising, kBuilding, kProving, kWriting };

/// The state of a run.
struct JobProgress {
    Phase phase = Phase::kOptimising;
    /// The phase in words: "optimising", "writing big.msh, 2 of 3".
    std::string text;
    /// The part of the phase that is done, from 0 to 1. It never falls within a phase. Negative:
    /// unknown.
    double fraction = -1;
    /// The last iteration.
    Progress run;
};

/// Called on the calling thread once an iteration, at the beginning of each phase and of each file,
/// and about ten times a second while a longer step lasts. Returning false cancels the run.
using JobCallback = std::function<bool(const JobProgress&)>;

/// Reports the progress of one run to its callback. The thread that makes a monitor works for it
/// while it lives, and so do all threads that help it: each checkpoint of theirs ends a cancelled
/// run.
///
///   JobMonitor monitor(callback, job);
///   compute_cvt(lattice, points, {{.progress = [&](auto& p) { return monitor.iteration(p); }}});
///   monitor.watch([&] {
///       monitor.begin(Phase::kBuilding, "building the tile");
///       build();
///   });
class JobMonitor final : public Client {
   public:
    /// @param callback  may be empty.
    /// @param job       states the ends of the optimisation, from which its fraction follows.
    /// Both must outlive the monitor.
    JobMonitor(const JobCallback& callback, const Job& job);
    JobMonitor(const JobCallback& callback, Job&& job) = delete;

    /// Throws Cancelled in a cancelled run. On the calling thread, calls the callback if it was not
    /// called for a while. Then passes the client for which that thread worked before.
    void pass() override;

    /// Report one iteration of the start, or of the optimisation. For the calling thread.
    /// @returns whether the run goes on.
    bool start_iteration(const Progress& progress);
    bool iteration(const Progress& progress);
    /// Reports one step of the Newton method that finds the weights of prescribed areas. For the
    /// calling thread.
    /// @param error  the largest relative error of an area.
    /// @throws Cancelled in a cancelled run.
    void newton_step(int step, double error);

    /// Runs `work` on a thread of its own while this one calls the callback, so that a long step
    /// does not delay it. For the calling thread.
    /// @throws Cancelled, or the exception of `work`.
    void watch(const std::function<void()>& work);

    // The steps of the work. Any thread may call them; they throw Cancelled in a cancelled run.

    void begin(Phase phase, const std::string& text);
    /// Changes the words of the phase.
    void describe(const std::string& text);
    /// Raises the fraction of the phase to `fraction`.
    void advance(double fraction);

   private:
    bool report(const JobProgress& progress);
    void begin_optimising();
    std::string optimising_words() const;
    void report_until(const bool& ended);
    void require_wanted() const;

    const JobCallback& callback_;
    const Job& job_;
    /// Follows the words of the optimisation, ", seed 4".
    std::string note_;
    /// The residual of the first iteration and the error of the first Newton step; below 0:
    /// unknown.
    double first_residual_ = -1;
    double first_error_ = -1;

    std::mutex mutex_;
    std::condition_variable changed_;
    JobProgress now_;
    /// States that the callback must see before `now_`.
    std::vector<JobProgress> unseen_;
    std::atomic<bool> cancelled_ = false;
    std::thread::id caller_ = std::this_thread::get_id();
    Client* outer_ = current_client();
    /// When the callback was called last.
    std::chrono::milliseconds reported_;
    ClientScope scope_{this};
};

}  // namespace pcvt
