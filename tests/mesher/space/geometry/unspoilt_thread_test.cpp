#include "mesher/space/geometry/unspoilt_thread.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <thread>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {
namespace {

std::thread::id thread_of_work() {
    std::thread::id id;
    run_in_unspoilt_thread([&] { id = std::this_thread::get_id(); });
    return id;
}

void spoil() {
    const auto fail = [] { run_in_unspoilt_thread([] { throw std::bad_alloc(); }); };
    EXPECT_THROW(fail(), std::bad_alloc);
}

/// Runs a test in a thread that is not spoilt yet.
void in_fresh_thread(void (*test)()) { std::thread(test).join(); }

TEST(UnspoiltThread, IsThisOneUntilMemoryEnds) {
    in_fresh_thread([] {
        EXPECT_EQ(thread_of_work(), std::this_thread::get_id());
        EXPECT_THROW(run_in_unspoilt_thread([] { throw std::runtime_error("other"); }),
                     std::runtime_error);
        EXPECT_EQ(thread_of_work(), std::this_thread::get_id());
        spoil();
        EXPECT_NE(thread_of_work(), std::this_thread::get_id());
        spoil();
        EXPECT_NE(thread_of_work(), std::this_thread::get_id());
    });
}

class Anyone final : public Client {
   public:
    void pass() override {}
};

TEST(UnspoiltThread, WorksForTheSameClient) {
    in_fresh_thread([] {
        Anyone anyone;
        const ClientScope scope(&anyone);
        spoil();
        Client* client = nullptr;
        run_in_unspoilt_thread([&] { client = current_client(); });
        EXPECT_EQ(client, &anyone);
    });
}

}  // namespace
}  // namespace pcvt::space
