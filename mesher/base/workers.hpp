#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {

/// A fixed team of threads for loops over independent tasks.
///
/// The assignment of tasks to threads changes from run to run. Results stay reproducible if a task
/// depends only on its index, never on the thread or on the number of threads, and if sums over
/// tasks are added up afterwards in the order of the tasks.
///
/// Example usage:
///
///     Workers workers(8);
///     std::vector<double> sums(n_tasks);
///     workers.for_each(n_tasks, [&](int k) { sums[k] = sum_of_block(k); });
///     const double total = std::accumulate(sums.begin(), sums.end(), 0.0);
class Workers {
   public:
    /// @param n_threads  at least 1, the calling thread included. The team is smaller where the
    ///                   system cannot create that many threads.
    explicit Workers(int n_threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    int n_threads() const { return static_cast<int>(team_.size()) + 1; }

    /// Calls each of task(0) ... task(n_tasks - 1) once and returns when all have finished. If
    /// tasks throw, one of their exceptions is rethrown, and tasks that have not begun are left
    /// out. The tasks work for the client of the calling thread, with a checkpoint before each
    /// task. A task must not call for_each of its own team.
    void for_each(int n_tasks, const std::function<void(int)>& task);

   private:
    void serve();
    void work_through(std::unique_lock<std::mutex>& lock);

    std::mutex mutex_;
    std::condition_variable work_there_;
    std::condition_variable work_done_;
    const std::function<void(int)>* task_ = nullptr;
    Client* client_ = nullptr;
    int n_tasks_ = 0;
    int next_task_ = 0;
    int n_running_ = 0;
    std::exception_ptr failure_;
    bool closing_ = false;
    std::vector<std::thread> team_;
};

}  // namespace pcvt
