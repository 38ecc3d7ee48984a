/// Sets of several runs, threads and hosts that change the same files at the same time.

#include <gmock/gmock.h>

#include <atomic>
#include <filesystem>
#include <future>
#include <thread>

#include "io/outputs/output_set.hpp"
#include "io/outputs/recovery.hpp"
#include "mesher/base/checkpoint.hpp"
#include "tests/support/killed_process.hpp"
#include "tests/support/temporary_folder.hpp"

/// Waiting for the disk would take most of the time of these tests.
extern "C" int fsync(int) { return 0; }

namespace pcvt {
namespace {

using testing::bytes_of;
using ::testing::ElementsAre;
using testing::in_killed_process;
using ::testing::IsEmpty;
using testing::TemporaryFolder;
using testing::write_bytes;

constexpr int kRounds = 20;
constexpr int kThreads = 8;

TEST(Threads, ASetWaitsUntilTheOneBeforeItIsCommitted) {
    const TemporaryFolder folder;
    OutputSet first;
    first.stage(folder / "a", "first");
    first.wait_for_turn({});
    std::promise<std::string> waits;
    std::thread other([&] {
        OutputSet second;
        second.stage(folder / "a", "second");
        second.wait_for_turn([&](const std::string& words) { waits.set_value(words); });
        second.commit(true);
    });
    EXPECT_EQ(waits.get_future().get() + "/a",
              "waiting for another run that writes to " + (folder / "a"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a"));
    first.commit(true);
    other.join();
    EXPECT_EQ(bytes_of(folder / "a"), "second");
    EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(Turns, ASetThatIsNotCommittedHandsItsTurnOn) {
    const TemporaryFolder folder;
    {
        OutputSet first;
        first.stage(folder / "a", "first");
        first.wait_for_turn({});
    }
    EXPECT_THAT(folder.names(), IsEmpty());
    OutputSet second;
    second.stage(folder / "a", "second");
    second.commit(false);
}

/// Ends the work at the third checkpoint.
class ThirdCheckpoint final : public Client {
   public:
    void pass() override {
        if (++n_passes_ == 3) throw Cancelled{};
    }

   private:
    int n_passes_ = 0;
};

TEST(Turns, WaitingCanBeCancelled) {
    const TemporaryFolder folder;
    OutputSet first;
    first.stage(folder / "a", "first");
    first.wait_for_turn({});
    {
        OutputSet second;
        second.stage(folder / "a", "second");
        ThirdCheckpoint client;
        const ClientScope scope(&client);
        EXPECT_THROW(second.wait_for_turn({}), Cancelled);
    }
    first.commit(false);
    EXPECT_EQ(bytes_of(folder / "a"), "first");
    EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(Turns, TheTurnOfAKilledProcessEndsWithIt) {
    const TemporaryFolder folder;
    const auto kill = [&] {
        in_killed_process([&] {
            auto* set = new OutputSet;
            set->stage(folder / "a", "killed");
            set->wait_for_turn({});
        });
        // The lock, the run file and the temporary file.
        EXPECT_EQ(folder.names().size(), 3U);
    };
    kill();
    OutputSet set;
    set.stage(folder / "a", "x");
    set.commit(false);
    EXPECT_EQ(folder.names().size(), 3U);
    recover_unfinished({folder / "a"});
    EXPECT_THAT(folder.names(), ElementsAre("a"));
    std::filesystem::remove(folder / "a");
    kill();
    recover_unfinished({folder / "a"});
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Turns, ASetWhoseRunDiedMeanwhileIsRecoveredFirst) {
    const TemporaryFolder folder;
    OutputSet set;
    for (const char* name : {"a", "out/b"}) set.stage(folder / name, "new");
    in_killed_process([&] {
        // The journal as it is when a process dies between the two moves.
        auto* dead = new OutputSet;
        for (const char* name : {"a", "out/b"}) dead->stage(folder / name, "dead");
        dead->commit(true);
    });
    const std::string token = "abcdefgh";
    const std::string leaf = temporary_leaf("c", token, 0);
    std::filesystem::rename(folder / "out", folder / leaf);
    Journal journal;
    journal.folders = {{"", token}};
    journal.moves = {{.kind = FileMove::Kind::kNewFolder,
                      .folder = 0,
                      .temporary = leaf,
                      .target = "out",
                      .fresh = {},
                      .old = {}}};
    write_bytes(folder / run_file_name(token), encode_journal(journal));

    EXPECT_THAT(set.wait_for_turn({}), ElementsAre(::testing::HasSubstr("complete now")));
    EXPECT_EQ(bytes_of(folder / "out/b"), "dead");
    set.commit(true);
    EXPECT_EQ(bytes_of(folder / "a"), "new");
    EXPECT_EQ(bytes_of(folder / "out/b"), "new");
    EXPECT_THAT(folder.names(), ElementsAre("a", "out"));
}

/// Commits a set of files, all with one content, while other sets are committed.
void write(const TemporaryFolder& folder, std::vector<std::string> names, const std::string& run) {
    recover_unfinished({folder / "x"});
    OutputSet set;
    for (const std::string& name : names) set.stage(folder / name, run);
    set.commit(true);
}

TEST(Threads, TheFilesOfSeveralThreadsAreThoseOfOneSet) {
    const std::vector<std::string> names = {"a", "c/x/a", "c/y/deep/b", "d/e", "z"};
    for (int round = 0; round < kRounds; ++round) {
        const TemporaryFolder folder;
        std::vector<std::thread> threads;
        for (int k = 0; k < kThreads; ++k) {
            threads.emplace_back([&, k] {
                std::vector<std::string> mine = names;
                // No two sets may wait for each other, in any order of their files.
                if (k % 2 == 1) std::reverse(mine.begin(), mine.end());
                write(folder, mine, std::to_string(k));
                write(folder, mine, std::to_string(k));
            });
        }
        for (std::thread& thread : threads) thread.join();
        for (const std::string& name : names) {
            ASSERT_EQ(bytes_of(folder / name), bytes_of(folder / "a")) << name;
        }
        ASSERT_THAT(folder.names(), ElementsAre("a", "c", "d", "z"));
    }
}

TEST(Threads, SetsOfOtherFilesInAFolderThatAllMakeAreAllWritten) {
    for (int round = 0; round < kRounds; ++round) {
        const TemporaryFolder folder;
        std::vector<std::thread> threads;
        for (int k = 0; k < kThreads; ++k) {
            threads.emplace_back([&, k] { write(folder, {"out/" + std::to_string(k)}, "x"); });
        }
        for (std::thread& thread : threads) thread.join();
        EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"), {}), kThreads);
    }
}

}  // namespace
}  // namespace pcvt
