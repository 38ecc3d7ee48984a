#include "mesher/base/checkpoint.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "mesher/base/workers.hpp"

namespace pcvt {
namespace {

/// Counts its checkpoints and ends the work at one of them.
class Counter final : public Client {
   public:
    explicit Counter(int last = -1) : last_(last) {}
    void pass() override {
        if (++n_passes_ == last_) throw Cancelled{};
    }
    int n_passes() const { return n_passes_; }

   private:
    int last_;
    std::atomic<int> n_passes_ = 0;
};

TEST(Checkpoint, CallsTheClientOfTheInnermostScope) {
    Counter outer;
    Counter inner;
    checkpoint();
    {
        const ClientScope scope(&outer);
        checkpoint();
        {
            const ClientScope within(&inner);
            checkpoint();
            const ClientScope none(nullptr);
            checkpoint();
        }
        checkpoint();
    }
    checkpoint();
    EXPECT_EQ(outer.n_passes(), 2);
    EXPECT_EQ(inner.n_passes(), 1);
}

TEST(Checkpoint, CountsTheItemsOfALoop) {
    Counter counter;
    const ClientScope scope(&counter);
    for (int k = 0; k < 4097; ++k) checkpoint_each(k);
    EXPECT_EQ(counter.n_passes(), 5);
    for (int k = 0; k < 64; ++k) checkpoint_each(k, 16);
    EXPECT_EQ(counter.n_passes(), 9);
}

TEST(Checkpoint, TeamsWorkForTheClientOfTheirCaller) {
    for (const int n_threads : {1, 4}) {
        Workers workers(n_threads);
        Counter counter;
        {
            const ClientScope scope(&counter);
            workers.for_each(100, [](int) { checkpoint(); });
        }
        EXPECT_EQ(counter.n_passes(), 200);
        workers.for_each(100, [](int) { checkpoint(); });
        EXPECT_EQ(counter.n_passes(), 200);
    }
}

TEST(Checkpoint, ACancelledLoopLeavesOutTheTasksThatHaveNotBegun) {
    for (const int n_threads : {1, 4}) {
        Workers workers(n_threads);
        Counter counter(10);
        const ClientScope scope(&counter);
        std::atomic<int> n_done = 0;
        // Each task takes a while: a busy system may stop the cancelling thread before it has
        // stopped the others, which must not finish many tasks meanwhile.
        const auto task = [&](int) {
            ++n_done;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        };
        EXPECT_THROW(workers.for_each(20'000, task), Cancelled);
        EXPECT_LT(n_done, 5'000);
        // The team works on.
        workers.for_each(100, [&](int) { ++n_done; });
        EXPECT_GE(n_done, 100);
    }
}

}  // namespace
}  // namespace pcvt
