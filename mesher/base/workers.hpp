#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace pcvt {

/// A fixed team of threads for loops over independent tasks.
///
/// How the tasks fall to the threads changes from run to run. So that results do not, a task must
/// depend on its index alone, never on the thread or on the number of threads, and sums over tasks
/// are added up afterwards in the order of the tasks.
class Workers {
   public:
    /// @param n_threads  at least 1; the calling thread is one of them. Where the system gives no
    ///                   more threads there are fewer.
    explicit Workers(int n_threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    int n_threads() const { return static_cast<int>(team_.size()) + 1; }

    /// Calls task(0) ... task(n_tasks - 1), each once, and returns when all are done. Of several
    /// exceptions that the tasks throw one is thrown on. Not to be called from within a task.
    void for_each(int n_tasks, const std::function<void(int)>& task);

   private:
    void serve();
    void work_through(std::unique_lock<std::mutex>& lock);

    std::mutex mutex_;
    std::condition_variable work_there_;
    std::condition_variable work_done_;
    const std::function<void(int)>* task_ = nullptr;
    int n_tasks_ = 0;
    int next_task_ = 0;
    int n_running_ = 0;
    std::exception_ptr failure_;
    bool closing_ = false;
    std::vector<std::thread> team_;
};

}  // namespace pcvt
