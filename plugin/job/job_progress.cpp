#include "plugin/job/job_progress.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "plugin/job/job.hpp"

namespace pcvt {
namespace {

/// The time between two calls of the callback in a long step.
constexpr std::chrono::milliseconds kBetweenCalls{100};

/// About the relative error at which the search for weights ends.
constexpr double kAreaGoal = 1e-10;

/// A clock of a few milliseconds' resolution that costs a few nanoseconds.
std::chrono::milliseconds coarse_time() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC_COARSE, &time);
    return std::chrono::seconds(time.tv_sec) +
           std::chrono::duration_cast<std::chrono::milliseconds>(
               std::chrono::nanoseconds(time.tv_nsec));
}

/// The part of the way that a residual has come down, on a logarithmic scale.
double share_of_digits(double first, double residual, double tolerance) {
    if (!(first > tolerance) || !(tolerance > 0) || !(residual > 0)) return 0;
    return std::log(first / residual) / std::log(first / tolerance);
}

double share_of_start(const Progress& progress) {
    return progress.budget > 0 ? double(progress.evaluations) / progress.budget : progress.share;
}

}  // namespace

JobMonitor::JobMonitor(const JobCallback& callback, const Job& job)
    : callback_(callback),
      job_(job),
      note_(job.retries > 0 ? ", seed " + std::to_string(job.seed) : ""),
      reported_(coarse_time()) {
    now_ = {.phase = Phase::kStarting, .text = "starting" + note_, .fraction = 0, .run = {}};
}

bool JobMonitor::report(const JobProgress& progress) {
    if (!callback_) return true;
    // The callback is not part of the work, so that calls in it are not cancelled.
    const ClientScope scope(nullptr);
    const bool wanted = callback_(progress);
    reported_ = coarse_time();
    return wanted;
}

void JobMonitor::pass() {
    const bool is_caller = std::this_thread::get_id() == caller_;
    if (is_caller && callback_ && coarse_time() - reported_ >= kBetweenCalls) {
        if (!report(now_)) cancelled_ = true;
    }
    require_wanted();
    if (outer_ != nullptr) outer_->pass();
}

void JobMonitor::require_wanted() const {
    if (cancelled_) throw Cancelled{};
}

bool JobMonitor::start_iteration(const Progress& progress) {
    now_.phase = Phase::kStarting;
    now_.text = (progress.budget > 0 ? "searching" : "placing the sites") + note_;
    now_.fraction = std::clamp(share_of_start(progress), now_.fraction, 1.0);
    now_.run = progress;
    now_.run.positions = nullptr;  // A start moves other sites than the run.
    return report(now_);
}

void JobMonitor::begin_optimising() {
    if (now_.phase == Phase::kOptimising) return;
    now_ = {.phase = Phase::kOptimising, .text = {}, .fraction = 0, .run = {}};
}

std::string JobMonitor::optimising_words() const {
    if (!job_.sizes || job_.run.max_iterations < 0) return "optimising" + note_;
    if (first_residual_ < 0) {
        return job_.is_in_space() ? "fitting the volumes" : "fitting the areas";
    }
    const int n = job_.run.max_iterations;
    return "centroidal step " + std::to_string(std::min(now_.run.iteration + 1, n)) + " of " +
           std::to_string(n);
}

void JobMonitor::newton_step(int step, double error) {
    begin_optimising();
    if (first_error_ < 0) first_error_ = error;
    now_.text = optimising_words() + ", Newton step " + std::to_string(step);
    if (job_.run.max_iterations == 0) {
        const double share = share_of_digits(first_error_, error, kAreaGoal);
        now_.fraction = std::clamp(share, now_.fraction, 1.0);
    }
    if (!report(now_)) cancelled_ = true;
    require_wanted();
}

bool JobMonitor::iteration(const Progress& progress) {
    begin_optimising();
    if (first_residual_ < 0) first_residual_ = progress.residual;
    double share = share_of_digits(first_residual_, progress.residual, job_.run.tolerance);
    if (job_.run.max_iterations > 0) {
        share = std::max(share, double(progress.iteration) / job_.run.max_iterations);
    }
    now_.fraction = std::clamp(share, now_.fraction, 1.0);
    now_.run = progress;
    now_.text = optimising_words();
    const bool wanted = report(now_);
    now_.run.positions = nullptr;  // They are valid only during this call.
    return wanted;
}

void JobMonitor::watch(const std::function<void()>& work) {
    if (!callback_) {
        work();
        return;
    }
    std::exception_ptr fault;
    bool ended = false;
    const auto run = [&] {
        const ClientScope scope(this);
        try {
            work();
        } catch (...) {
            fault = std::current_exception();
        }
        const std::lock_guard lock(mutex_);
        ended = true;
        changed_.notify_one();
    };
    std::thread worker;
    try {
        worker = std::thread(run);
    } catch (const std::system_error&) {
        run();  // Without a second thread the callback hears of the phases at the end.
    }
    const auto join = [&worker] {
        if (worker.joinable()) worker.join();
    };
    try {
        report_until(ended);
    } catch (...) {
        cancelled_ = true;
        join();
        throw;
    }
    join();
    require_wanted();
    if (fault) std::rethrow_exception(fault);
}

/// Reports every change, and the state at least every kBetweenCalls, until the work has ended.
void JobMonitor::report_until(const bool& ended) {
    std::unique_lock lock(mutex_);
    for (bool last = false; !last;) {
        changed_.wait_for(lock, kBetweenCalls, [&] { return ended || !unseen_.empty(); });
        last = ended;
        std::vector<JobProgress> states = std::exchange(unseen_, {});
        states.push_back(now_);
        lock.unlock();
        for (const JobProgress& state : states) {
            if (!cancelled_ && !report(state)) cancelled_ = true;
        }
        lock.lock();
    }
}

void JobMonitor::begin(Phase phase, const std::string& text) {
    require_wanted();
    const std::lock_guard lock(mutex_);
    // The end of the phase before, unless that was the optimisation, which reports by itself.
    if (now_.phase >= Phase::kBuilding) unseen_.push_back(now_);
    now_.phase = phase;
    now_.text = text;
    now_.fraction = 0;
    unseen_.push_back(now_);
    changed_.notify_one();
}

void JobMonitor::describe(const std::string& text) {
    require_wanted();
    const std::lock_guard lock(mutex_);
    now_.text = text;
    unseen_.push_back(now_);
    changed_.notify_one();
}

void JobMonitor::advance(double fraction) {
    require_wanted();
    const std::lock_guard lock(mutex_);
    now_.fraction = std::clamp(fraction, now_.fraction, 1.0);
}

}  // namespace pcvt
