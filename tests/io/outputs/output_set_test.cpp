#include "io/outputs/output_set.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <iterator>

#include "io/bytes/output_error.hpp"
#include "io/outputs/writable_paths.hpp"
#include "mesher/base/checkpoint.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using testing::bytes_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;
using testing::TemporaryFolder;
using testing::write_bytes;

template <class Action>
std::string fault_of(Action action) {
    try {
        action();
    } catch (const OutputError& fault) {
        return fault.what();
    }
    return "";
}

/// Limits the size of files to `bytes` within its scope, which simulates a full disk on any
/// machine.
class FileSizeLimit {
   public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

   private:
    void (*handler_)(int);
    rlimit before_{};
};

TEST(Output, FilesAppearWithTheCommitAndNotBefore) {
    const TemporaryFolder folder;
    OutputSet set;
    set.stage(folder / "a", "first");
    set.stage(folder / "b", std::string(300'000, 'x'));
    EXPECT_FALSE(std::filesystem::exists(folder / "a"));
    EXPECT_TRUE(set.holds(folder / "b", std::string(300'000, 'x')));
    set.commit(false);
    EXPECT_THAT(folder.names(), ElementsAre("a", "b"));
    EXPECT_EQ(bytes_of(folder / "a"), "first");
}

TEST(Output, TemporaryFilesAreHiddenBesideTheirTarget) {
    const TemporaryFolder folder;
    OutputSet set;
    set.stage(folder / "tile.obj", "x");
    ASSERT_EQ(folder.names().size(), 2U);
    EXPECT_THAT(folder.names()[0], ::testing::MatchesRegex("\\.pcvt-[0-9a-z]{8}"));
    EXPECT_THAT(folder.names()[1],
                ::testing::MatchesRegex("\\.tile\\.obj\\.pcvt-[0-9a-z]{8}-0\\.new"));
}

TEST(Output, FilesThatAreNotCommittedAreRemoved) {
    const TemporaryFolder folder;
    {
        OutputSet set;
        set.stage(folder / "a", "x");
    }
    EXPECT_THAT(folder.names(), IsEmpty());
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

std::ptrdiff_t n_open_files() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
}

TEST(Output, ALargeFileIsCancelledBetweenItsPieces) {
    const TemporaryFolder folder;
    const std::ptrdiff_t n_open = n_open_files();
    ThirdCheckpoint client;
    {
        OutputSet set;
        const ClientScope scope(&client);
        EXPECT_THROW(set.stage(folder / "a", std::string(std::size_t{20} << 20, 'x')), Cancelled);
    }
    EXPECT_EQ(n_open_files(), n_open);
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Output, AFileOfManyPiecesIsWrittenWhole) {
    const TemporaryFolder folder;
    std::string bytes((std::size_t{150} << 20) + 1, '\0');
    for (std::size_t k = 0; k < bytes.size(); k += 4099) bytes[k] = static_cast<char>(k % 251);
    OutputSet set;
    set.stage(folder / "a", bytes);
    EXPECT_TRUE(set.holds(folder / "a", bytes));
}

TEST(Output, ExistingFilesStayWithoutForce) {
    const TemporaryFolder folder;
    write_bytes(folder / "b", "old");
    {
        OutputSet set;
        set.stage(folder / "a", "new");
        set.stage(folder / "b", "new");
        EXPECT_EQ(fault_of([&] { set.commit(false); }),
                  (folder / "b") + ": cannot write: it exists");
    }
    EXPECT_THAT(folder.names(), ElementsAre("b"));
    EXPECT_EQ(bytes_of(folder / "b"), "old");
}

TEST(Output, ForceReplacesAndKeepsNoBackup) {
    const TemporaryFolder folder;
    write_bytes(folder / "a", "old");
    OutputSet set;
    set.stage(folder / "a", "new");
    set.commit(true);
    EXPECT_THAT(folder.names(), ElementsAre("a"));
    EXPECT_EQ(bytes_of(folder / "a"), "new");
}

TEST(Output, ACommitThatFailsHalfWayIsUndone) {
    const TemporaryFolder folder;
    write_bytes(folder / "a", "old");
    {
        OutputSet set;
        for (const char* name : {"a", "b", "c"}) set.stage(folder / name, "new");
        std::filesystem::create_directory(folder / "c");
        EXPECT_EQ(fault_of([&] { set.commit(true); }),
                  (folder / "c") + ": cannot write: Is a directory");
    }
    EXPECT_THAT(folder.names(), ElementsAre("a", "c"));
    EXPECT_EQ(bytes_of(folder / "a"), "old");
}

TEST(Output, AReplacedFileIsRestoredWhereALaterMoveFails) {
    const TemporaryFolder folder;
    write_bytes(folder / "a", "old");
    {
        OutputSet set;
        for (const char* name : {"a", "b", "d/c"}) set.stage(folder / name, "new");
        write_bytes(folder / "d", "a file where a folder is needed");
        EXPECT_THAT(fault_of([&] { set.commit(true); }), HasSubstr("d/c: cannot write: Not a dir"));
    }
    EXPECT_THAT(folder.names(), ElementsAre("a", "d"));
    EXPECT_EQ(bytes_of(folder / "a"), "old");
}

TEST(Output, AStagedFileThatCannotBeReadBackIsAnErrorOfTheOutput) {
    const TemporaryFolder folder;
    OutputSet set;
    set.stage(folder / "a", "x");
    for (const std::string& name : folder.names()) std::filesystem::remove(folder / name);
    EXPECT_THAT(fault_of([&] { set.holds(folder / "a", "x"); }), HasSubstr("cannot be read back"));
}

TEST(Output, AFullDiskIsReportedAndLeavesNoFile) {
    const TemporaryFolder folder;
    {
        OutputSet set;
        const FileSizeLimit limit(1000);
        set.stage(folder / "small", std::string(1000, 'x'));
        EXPECT_EQ(fault_of([&] { set.stage(folder / "large", std::string(1001, 'x')); }),
                  (folder / "large") + ": cannot write: File too large");
    }
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Output, PermissionsFollowTheUmask) {
    const TemporaryFolder folder;
    const mode_t before = umask(0027);
    OutputSet set;
    set.stage(folder / "a", "x");
    set.commit(false);
    umask(before);
    struct stat status {};
    ASSERT_EQ(stat((folder / "a").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640U);
}

TEST(Output, UnwritableTargetsAreRefusedBeforeAnyWork) {
    const TemporaryFolder folder;
    write_bytes(folder / "old", "x");
    const auto fault = [](const std::string& path, bool force = false) {
        return fault_of([&] { require_writable(path, force); });
    };
    EXPECT_EQ(fault(folder / "new"), "");
    EXPECT_EQ(fault(folder / "old", true), "");
    EXPECT_EQ(fault(folder / "old"), (folder / "old") + ": cannot write: it exists");
    std::filesystem::create_directory(folder / "d");
    EXPECT_EQ(fault(folder / "d", true), (folder / "d") + ": cannot write: Is a directory");
    EXPECT_EQ(fault(folder / "none/deep/x"), "");
    EXPECT_THAT(fault(folder / (std::string(256, 'n') + "/x")), HasSubstr("File name too long"));
    EXPECT_THAT(fault(folder / "old/deep/x"), HasSubstr("old: Not a directory"));
    EXPECT_THAT(fault(folder / "old/x"), HasSubstr("Not a directory"));
    EXPECT_THAT(fault("/dev/null", true), HasSubstr("not a regular file"));
    EXPECT_THAT(fault(""), StartsWith(": cannot write: the path has no file name"));
}

TEST(Output, FilesWithTheLongestNamesAreWritten) {
    const TemporaryFolder folder;
    const std::string name(255, 'n');
    OutputSet set;
    set.stage(folder / name, "x");
    set.commit(false);
    EXPECT_THAT(folder.names(), ElementsAre(name));
}

TEST(Output, MissingFoldersAppearInTheCommit) {
    const TemporaryFolder folder;
    OutputSet set;
    set.stage_folder(folder / "cases/c");
    set.stage(folder / "cases/c/x/a", "first");
    set.stage(folder / "out/deep/b", "second");
    EXPECT_FALSE(std::filesystem::exists(folder / "cases"));
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
    set.commit(false);
    EXPECT_THAT(folder.names(), ElementsAre("cases", "out"));
    EXPECT_EQ(bytes_of(folder / "cases/c/x/a"), "first");
    EXPECT_EQ(bytes_of(folder / "out/deep/b"), "second");
}

TEST(Output, ACommitThatFailsRemovesTheFoldersThatItMade) {
    const TemporaryFolder folder;
    {
        OutputSet set;
        set.stage(folder / "out/deep/a", "x");
        set.stage(folder / "b/c", "x");
        write_bytes(folder / "b", "a file where a folder is needed");
        EXPECT_THAT(fault_of([&] { set.commit(false); }),
                    HasSubstr("b/c: cannot write: Not a dir"));
    }
    EXPECT_THAT(folder.names(), ElementsAre("b"));
}

TEST(Output, AFolderAppearsAsAWhole) {
    const TemporaryFolder folder;
    OutputSet set;
    set.stage_folder(folder / "c");
    set.stage(folder / "c/x/y/a", "first");
    set.stage(folder / "c/x/b", "second");
    ASSERT_EQ(folder.names().size(), 2U);
    EXPECT_THAT(folder.names()[0], StartsWith(".c.pcvt-"));
    EXPECT_TRUE(set.holds(folder / "c/x/b", "second"));
    set.commit(false);
    EXPECT_THAT(folder.names(), ElementsAre("c"));
    EXPECT_EQ(bytes_of(folder / "c/x/y/a"), "first");
}

TEST(Output, AFolderThatIsNotCommittedIsRemoved) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "old");
    {
        OutputSet set;
        for (const char* name : {"new", "old"}) {
            set.stage_folder(folder / name);
            set.stage((folder / name) + "/x/a", "x");
        }
    }
    EXPECT_THAT(folder.names(), ElementsAre("old"));
    EXPECT_TRUE(std::filesystem::is_empty(folder / "old"));
}

TEST(Output, AFolderCreatedMeanwhileStaysAndTheCommitIsUndone) {
    const TemporaryFolder folder;
    {
        OutputSet set;
        set.stage(folder / "a", "x");
        for (const char* name : {"c", "d"}) {
            set.stage_folder(folder / name);
            set.stage((folder / name) + "/b", "x");
        }
        std::filesystem::create_directory(folder / "d");
        EXPECT_EQ(fault_of([&] { set.commit(false); }),
                  (folder / "d") + ": cannot write: it exists");
    }
    EXPECT_THAT(folder.names(), ElementsAre("d"));
    EXPECT_TRUE(std::filesystem::is_empty(folder / "d"));
}

TEST(Output, OnlyStagedFilesOfAnExistingFolderAreReplaced) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "c/x");
    write_bytes(folder / "c/x/a", "old");
    write_bytes(folder / "c/x/mine", "mine");
    OutputSet set;
    set.stage_folder(folder / "c");
    set.stage(folder / "c/x/a", "new");
    set.stage(folder / "c/y/b", "new");
    EXPECT_EQ(bytes_of(folder / "c/x/a"), "old");
    set.commit(true);
    EXPECT_EQ(bytes_of(folder / "c/x/a"), "new");
    EXPECT_EQ(bytes_of(folder / "c/y/b"), "new");
    EXPECT_EQ(bytes_of(folder / "c/x/mine"), "mine");
}

TEST(Output, UnwritableFoldersAreRefusedBeforeAnyWork) {
    const TemporaryFolder folder;
    const auto fault = [&](const std::string& name, bool force) {
        const std::vector<std::string> paths = {folder / (name + "/x/a")};
        return fault_of([&] { require_writable_folder(folder / name, paths, force); });
    };
    EXPECT_EQ(fault("new", false), "");
    std::filesystem::create_directory(folder / "old");
    EXPECT_EQ(fault("old", true), "");
    EXPECT_EQ(fault("old", false), (folder / "old") + ": cannot write: it exists");
    write_bytes(folder / "old/x", "a file where a folder is needed");
    EXPECT_THAT(fault("old", true), HasSubstr("Not a directory"));
    write_bytes(folder / "file", "x");
    EXPECT_THAT(fault("file", true), HasSubstr("it exists and is not a folder"));
    EXPECT_EQ(fault("none/new", false), "");
}

TEST(Output, FilesThatWereNotStagedCannotBeReadBack) {
    EXPECT_THROW(OutputSet().holds("a", ""), InternalError);
}

}  // namespace
}  // namespace pcvt
