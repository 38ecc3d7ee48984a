#include "io/outputs/recovery.hpp"

#include <gmock/gmock.h>

#include "io/bytes/output_error.hpp"
#include "io/outputs/output_set.hpp"
#include "tests/support/killed_process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using testing::bytes_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::in_killed_process;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::TemporaryFolder;
using testing::write_bytes;

constexpr const char* kToken = "abcdefgh";

FileStamp stamp_of(const std::string& path) {
    NameStatus status;
    EXPECT_EQ(look_up(path.c_str(), status), 0);
    return status.stamp;
}

/// A set whose run was killed in its commit: `a` and `b` replace old files, `out` is a new folder
/// that holds `c`.
class KilledCommit {
   public:
    KilledCommit() {
        for (const char* name : {"a", "b"}) {
            write_bytes(folder / name, "before");
            add(FileMove::Kind::kReplacement, name, stamp_of(folder / name));
        }
        add(FileMove::Kind::kNewFolder, "out", {});
        write_bytes(folder / run_file_name(kToken), encode_journal(journal_));
    }
    /// Takes a number of the steps of a move: a second name for the old file, then the rename.
    void advance(std::size_t move, int steps) {
        const std::string temporary = folder / temporary_leaf("x", kToken, move);
        const std::string target = folder / std::string(std::array{"a", "b", "out"}[move]);
        if (steps > 0 && move < 2) {
            std::filesystem::create_hard_link(target, backup_path(temporary));
        }
        if (steps > 1) std::filesystem::rename(temporary, target);
    }
    std::vector<std::string> recover() { return recover_unfinished({folder / "tile.obj"}); }

    TemporaryFolder folder;

   private:
    void add(FileMove::Kind kind, const char* target, const FileStamp& old) {
        const std::string leaf = temporary_leaf("x", kToken, journal_.moves.size());
        if (kind == FileMove::Kind::kNewFolder) {
            std::filesystem::create_directory(folder / leaf);
            write_bytes(folder / (leaf + "/c"), "new");
        } else {
            write_bytes(folder / leaf, "new");
        }
        journal_.moves.push_back({.kind = kind,
                                  .folder = 0,
                                  .temporary = leaf,
                                  .target = target,
                                  .fresh = stamp_of(folder / leaf),
                                  .old = old});
    }

    Journal journal_{.folders = {{"", kToken}}, .moves = {}};
};

TEST(Recovery, ACommitThatWasKilledAnywhereIsCompleted) {
    for (int state = 0; state < 27; ++state) {
        KilledCommit set;
        set.advance(0, state % 3);
        set.advance(1, state / 3 % 3);
        set.advance(2, state / 9);
        EXPECT_THAT(set.recover(), ElementsAre(HasSubstr("3 files are complete now"))) << state;
        EXPECT_THAT(set.folder.names(), ElementsAre("a", "b", "out")) << state;
        for (const char* name : {"a", "b", "out/c"}) EXPECT_EQ(bytes_of(set.folder / name), "new");
        EXPECT_THAT(set.recover(), IsEmpty());
    }
}

TEST(Recovery, ACommitIsTakenBackWhereAnOldFileHasChangedSince) {
    for (int state = 0; state < 27; ++state) {
        KilledCommit set;
        set.advance(0, state % 3);
        set.advance(2, state / 9);
        write_bytes(set.folder / "b", "written by somebody else");
        EXPECT_THAT(set.recover(), ElementsAre(HasSubstr("those of before"))) << state;
        EXPECT_THAT(set.folder.names(), ElementsAre("a", "b")) << state;
        EXPECT_EQ(bytes_of(set.folder / "a"), "before");
        EXPECT_EQ(bytes_of(set.folder / "b"), "written by somebody else");
    }
}

TEST(Recovery, FilesOfARunThatDiedBeforeItsCommitAreRemoved) {
    const TemporaryFolder folder;
    in_killed_process([&] {
        auto* set = new OutputSet;
        set->stage(folder / "a", "x");
        set->stage_folder(folder / "c");
        set->stage(folder / "c/d/e", "x");
        set->stage(folder / "out/deep/b", "x");
    });
    EXPECT_THAT(folder.names(), SizeIs(4));
    EXPECT_THAT(recover_unfinished({folder / "out/deep/b"}), IsEmpty());
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Recovery, ALivingRunInTheSameFolderIsNotDisturbed) {
    const TemporaryFolder folder;
    OutputSet living;
    living.stage(folder / "a", "living");
    in_killed_process([&] {
        if (!recover_unfinished({folder / "b"}).empty()) std::abort();
        OutputSet other;
        other.stage(folder / "b", "other");
        other.commit(false);
    });
    recover_unfinished({folder / "b"});
    EXPECT_TRUE(living.holds(folder / "a", "living"));
    living.commit(false);
    EXPECT_THAT(folder.names(), ElementsAre("a", "b"));
}

TEST(Recovery, ASetInSeveralFoldersIsCompletedFromAnyOfThem) {
    for (const char* first : {"x", "y"}) {
        const TemporaryFolder folder;
        std::filesystem::create_directory(folder / "x");
        std::filesystem::create_directory(folder / "y");
        write_bytes(folder / "y/b", "before");
        const std::string in_x = temporary_leaf("a", kToken, 0);
        const std::string in_y = temporary_leaf("b", kToken, 1);
        write_bytes(folder / ("x/" + in_x), "new");
        write_bytes(folder / ("y/" + in_y), "new");
        Journal journal;
        journal.folders = {{"", kToken}, {folder / "y", kToken}};
        journal.moves = {{.kind = FileMove::Kind::kNewFile,
                          .folder = 0,
                          .temporary = in_x,
                          .target = "a",
                          .fresh = stamp_of(folder / ("x/" + in_x)),
                          .old = {}},
                         {.kind = FileMove::Kind::kReplacement,
                          .folder = 1,
                          .temporary = in_y,
                          .target = "b",
                          .fresh = stamp_of(folder / ("y/" + in_y)),
                          .old = stamp_of(folder / "y/b")}};
        const std::string master = folder / ("x/" + run_file_name(kToken));
        write_bytes(master, encode_journal(journal));
        write_bytes(folder / ("y/" + run_file_name(kToken)), encode_pointer(master));
        EXPECT_TRUE(unfinished_set_of({folder / "y/b"}));
        EXPECT_FALSE(unfinished_set_of({folder / "y/other"}));
        EXPECT_THAT(recover_unfinished({folder / first + std::string("/z")}), SizeIs(1));
        EXPECT_EQ(bytes_of(folder / "x/a"), "new");
        EXPECT_EQ(bytes_of(folder / "y/b"), "new");
        EXPECT_EQ(std::distance(std::filesystem::recursive_directory_iterator(folder / ""), {}), 4);
        EXPECT_FALSE(unfinished_set_of({folder / "y/b"}));
    }
}

TEST(Recovery, MissingFilesOfAnUnfinishedSetAreFoundByARelativeName) {
    const KilledCommit set;
    // In a process of its own, as the folder of a process belongs to all of its threads.
    in_killed_process([&] {
        std::filesystem::current_path(set.folder / "");
        for (const char* name : {"a", "./b", "out/c", "./out/../out/c"}) {
            if (!unfinished_set_of({name})) std::abort();
        }
        if (unfinished_set_of({"c"}) || unfinished_set_of({"out/a"})) std::abort();
        std::filesystem::create_directory("out");
        if (!unfinished_set_of({"out/c"})) std::abort();
        std::filesystem::remove("a");
        if (!unfinished_set_of({"a"})) std::abort();
    });
}

TEST(Recovery, AJournalThatNoOtherFolderConfirmsChangesNothingThere) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "x");
    std::filesystem::create_directory(folder / "y");
    write_bytes(folder / "y/victim", "mine");
    const std::string leaf = temporary_leaf("victim", kToken, 0);
    write_bytes(folder / ("y/" + leaf), "planted");
    Journal journal;
    journal.folders = {{"", kToken}, {folder / "y", kToken}};
    journal.moves = {{.kind = FileMove::Kind::kReplacement,
                      .folder = 1,
                      .temporary = leaf,
                      .target = "victim",
                      .fresh = stamp_of(folder / ("y/" + leaf)),
                      .old = stamp_of(folder / "y/victim")}};
    write_bytes(folder / ("x/" + run_file_name(kToken)), encode_journal(journal));
    recover_unfinished({folder / "x/tile.obj"});
    EXPECT_EQ(bytes_of(folder / "y/victim"), "mine");
}

TEST(Recovery, AFolderIsLeftWhereSomebodyHasPutAFileIntoIt) {
    KilledCommit set;
    set.advance(2, 2);
    write_bytes(set.folder / "b", "written by somebody else");
    write_bytes(set.folder / "out/mine", "mine");
    EXPECT_THAT(set.recover(), ElementsAre(HasSubstr("those of before")));
    EXPECT_EQ(bytes_of(set.folder / "a"), "before");
    EXPECT_EQ(bytes_of(set.folder / "out/mine"), "mine");
}

TEST(Recovery, ASetIsLeftWhileAnotherOneIsCommittedInItsFolder) {
    KilledCommit set;
    OutputSet living;
    living.stage(set.folder / "other", "living");
    living.wait_for_turn({});
    EXPECT_THAT(set.recover(), IsEmpty());
    living.commit(false);
    EXPECT_THAT(set.recover(), SizeIs(1));
    EXPECT_THAT(set.folder.names(), ElementsAre("a", "b", "other", "out"));
}

TEST(Recovery, AJournalLeadsThroughNoSymbolicLink) {
    const TemporaryFolder folder;
    const TemporaryFolder elsewhere;
    const std::string leaf = temporary_leaf("c", kToken, 0);
    write_bytes(folder / leaf, "planted");
    const Journal journal{.folders = {{"", kToken}},
                          .moves = {{.kind = FileMove::Kind::kNewFile,
                                     .folder = 0,
                                     .temporary = leaf,
                                     .target = "out/c",
                                     .fresh = stamp_of(folder / leaf),
                                     .old = {}}}};
    write_bytes(folder / run_file_name(kToken), encode_journal(journal));
    std::filesystem::create_directory_symlink(elsewhere / "", folder / "out");
    recover_unfinished({folder / "tile.obj"});
    EXPECT_THAT(elsewhere.names(), IsEmpty());
}

}  // namespace
}  // namespace pcvt
