#include "mesher/base/workers.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

namespace pcvt {
namespace {

constexpr int kManyThreads = 9;

TEST(Workers, RunEachTaskOnce) {
    for (int n_threads = 1; n_threads <= kManyThreads; ++n_threads) {
        Workers workers(n_threads);
        EXPECT_EQ(workers.n_threads(), n_threads);
        for (const int n_tasks : {0, 1, 2, 3, 8, 100}) {
            std::vector<int> times(static_cast<std::size_t>(n_tasks), 0);
            workers.for_each(n_tasks, [&](int k) { ++times.at(k); });
            EXPECT_EQ(times, std::vector<int>(times.size(), 1));
        }
    }
}

// Each task waits until all the others have begun, so no thread can run two.
TEST(Workers, RunTasksConcurrently) {
    const int n = 4;
    Workers workers(n);
    std::atomic<int> n_begun = 0;
    std::atomic<bool> in_time = true;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    workers.for_each(n, [&](int) {
        ++n_begun;
        while (n_begun < n && in_time) {
            if (std::chrono::steady_clock::now() > deadline) in_time = false;
            std::this_thread::yield();
        }
    });
    EXPECT_TRUE(in_time);
}

TEST(Workers, UseNoMoreThreadsThanRequested) {
    Workers workers(3);
    std::mutex mutex;
    std::set<std::thread::id> threads;
    for (int loop = 0; loop < 200; ++loop) {
        workers.for_each(20, [&](int) {
            const std::lock_guard lock(mutex);
            threads.insert(std::this_thread::get_id());
        });
    }
    EXPECT_LE(threads.size(), 3);
    EXPECT_TRUE(threads.contains(std::this_thread::get_id()));
}

TEST(Workers, RunManyLoopsInSequence) {
    for (const int n_threads : {1, 2, 5}) {
        Workers workers(n_threads);
        std::vector<int> sums(7, 0);
        for (int loop = 0; loop < 10000; ++loop) {
            workers.for_each(loop % 8, [&](int k) { sums[k] += loop; });
        }
        // Task k runs in the loops with more than k tasks.
        for (int k = 0; k < 7; ++k) {
            int expected = 0;
            for (int loop = 0; loop < 10000; ++loop) expected += loop % 8 > k ? loop : 0;
            EXPECT_EQ(sums[k], expected);
        }
    }
}

TEST(Workers, RethrowTheExceptionOfATask) {
    for (const int n_threads : {1, 2, 6}) {
        Workers workers(n_threads);
        for (int loop = 0; loop < 100; ++loop) {
            std::atomic<int> n_running = 0;
            const auto task = [&](int k) {
                ++n_running;
                if (k % 10 == 3) {
                    --n_running;
                    throw std::runtime_error("task " + std::to_string(k));
                }
                --n_running;
            };
            try {
                workers.for_each(20, task);
                FAIL() << "nothing was thrown";
            } catch (const std::runtime_error& error) {
                const std::string what = error.what();
                EXPECT_TRUE(what == "task 3" || what == "task 13") << what;
            }
            EXPECT_EQ(n_running, 0);
        }
    }
}

TEST(Workers, RunAgainAfterAnException) {
    Workers workers(3);
    EXPECT_THROW(workers.for_each(8, [](int) { throw 7; }), int);
    std::vector<int> done(8, 0);
    EXPECT_NO_THROW(workers.for_each(8, [&](int k) { done[k] = 1; }));
    EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 8);
}

TEST(Workers, MayRunInsideATaskOfAnotherTeam) {
    Workers outer(3);
    std::vector<std::vector<int>> results(5);
    outer.for_each(5, [&](int k) {
        Workers inner(2);
        results[k].resize(6);
        inner.for_each(6, [&](int m) { results[k][m] = 10 * k + m; });
    });
    for (int k = 0; k < 5; ++k) {
        for (int m = 0; m < 6; ++m) EXPECT_EQ(results[k][m], 10 * k + m);
    }
}

TEST(Workers, AreCreatedAndDestroyedWithoutWork) {
    for (int k = 0; k < 100; ++k) const Workers workers(1 + k % 5);
}

}  // namespace
}  // namespace pcvt
