#include "mesher/base/workers.hpp"

#include <exception>
#include <utility>

namespace pcvt {

Workers::Workers(int n_threads) {
    try {
        for (int k = 1; k < n_threads; ++k) team_.emplace_back([this] { serve(); });
    } catch (const std::exception&) {
        // Without memory or another thread. Fewer threads do the same work, only slower; an
        // exception from here would destroy threads that run.
    }
}

Workers::~Workers() {
    {
        const std::lock_guard lock(mutex_);
        closing_ = true;
    }
    work_there_.notify_all();
    for (std::thread& thread : team_) thread.join();
}

void Workers::work_through(std::unique_lock<std::mutex>& lock) {
    while (next_task_ < n_tasks_) {
        const int index = next_task_++;
        ++n_running_;
        lock.unlock();
        std::exception_ptr failure;
        try {
            checkpoint();
            (*task_)(index);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (failure) {
            failure_ = failure;
            next_task_ = n_tasks_;
        }
        --n_running_;
    }
    if (n_running_ == 0) work_done_.notify_one();
}

void Workers::serve() {
    std::unique_lock lock(mutex_);
    for (;;) {
        work_there_.wait(lock, [this] { return closing_ || next_task_ < n_tasks_; });
        if (closing_) return;
        const ClientScope scope(client_);
        work_through(lock);
    }
}

void Workers::for_each(int n_tasks, const std::function<void(int)>& task) {
    if (team_.empty() || n_tasks <= 1) {
        for (int k = 0; k < n_tasks; ++k) {
            checkpoint();
            task(k);
        }
        return;
    }
    std::unique_lock lock(mutex_);
    task_ = &task;
    client_ = current_client();
    n_tasks_ = n_tasks;
    next_task_ = 0;
    work_there_.notify_all();
    work_through(lock);
    work_done_.wait(lock, [this] { return n_running_ == 0; });
    n_tasks_ = next_task_ = 0;
    task_ = nullptr;
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

}  // namespace pcvt
