// Commits while every allocation from some number on fails, and while a single one fails.

#include <gmock/gmock.h>

#include "io/outputs/output_set.hpp"
#include "io/outputs/recovery.hpp"
#include "tests/support/failing_new.hpp"
#include "tests/support/temporary_folder.hpp"

/// Waiting for the disk would take most of the time of these tests.
extern "C" int fsync(int) { return 0; }

namespace pcvt {
namespace {

using testing::allocations_left;
using testing::bytes_of;
using ::testing::ElementsAre;
using testing::fails_once;
using testing::TemporaryFolder;
using testing::write_bytes;

/// Commits a set over an old file with the k-th allocation failing; returns whether it succeeded.
bool commit(OutputSet& set, long k, bool once) {
    fails_once = once;
    allocations_left = k;
    try {
        set.commit(true);
        allocations_left = -1;
        return true;
    } catch (const std::bad_alloc&) {
        allocations_left = -1;
        return false;
    }
}

/// Returns whether the commit with the k-th allocation failing succeeded.
bool stays_whole(long k, bool once) {
    const TemporaryFolder folder;
    write_bytes(folder / "a", "old");
    bool succeeded = false;
    {
        OutputSet set;
        set.stage(folder / "a", "new");
        set.stage(folder / "b", "new");
        set.stage(folder / "out/c", "new");
        succeeded = commit(set, k, once);
    }
    EXPECT_EQ(bytes_of(folder / "a"), succeeded ? "new" : "old") << k;
    if (succeeded) {
        EXPECT_THAT(folder.names(), ElementsAre("a", "b", "out")) << k;
    } else {
        EXPECT_THAT(folder.names(), ElementsAre("a")) << k;
    }
    return succeeded;
}

TEST(CommitWithoutMemory, IsWholeOrDoesNotHappen) {
    for (const bool once : {true, false}) {
        long k = 0;
        while (!stays_whole(k, once)) ASSERT_LT(++k, 1000);
        EXPECT_GT(k, 20);
    }
}

TEST(CommitWithoutMemory, CanBeTakenBackWithoutMemory) {
    bool taken_back = false;
    for (long k = 0; !taken_back; ++k) {
        ASSERT_LT(k, 1000);
        const TemporaryFolder folder;
        write_bytes(folder / "a", "old");
        {
            OutputSet set;
            set.stage(folder / "a", "new");
            set.stage(folder / "d/b", "new");
            write_bytes(folder / "d", "a file where a folder is needed");
            try {
                allocations_left = k;
                fails_once = false;
                set.commit(true);
            } catch (const std::bad_alloc&) {
                allocations_left = -1;
            } catch (const std::exception&) {
                allocations_left = -1;
                taken_back = true;
            }
        }
        EXPECT_EQ(bytes_of(folder / "a"), "old") << k;
        EXPECT_THAT(folder.names(), ElementsAre("a", "d")) << k;
    }
}

}  // namespace
}  // namespace pcvt
