/// Files and folders that appear between the staging of a set and its commit.

#include <gmock/gmock.h>

#include <filesystem>

#include "io/bytes/output_error.hpp"
#include "io/outputs/output_set.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using testing::bytes_of;
using ::testing::ElementsAre;
using testing::TemporaryFolder;
using testing::write_bytes;

TEST(Meanwhile, AFileThatAppearsIsReplacedWithForce) {
    const TemporaryFolder folder;
    OutputSet set;
    set.stage(folder / "a", "new");
    write_bytes(folder / "a", "meanwhile");
    set.commit(true);
    EXPECT_EQ(bytes_of(folder / "a"), "new");
    EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(Meanwhile, AFileThatAppearsStaysWithoutForce) {
    const TemporaryFolder folder;
    {
        OutputSet set;
        set.stage(folder / "a", "new");
        set.stage(folder / "b", "new");
        write_bytes(folder / "b", "meanwhile");
        EXPECT_THROW(set.commit(false), OutputExists);
    }
    EXPECT_EQ(bytes_of(folder / "b"), "meanwhile");
    EXPECT_THAT(folder.names(), ElementsAre("b"));
}

TEST(Meanwhile, AFileThatDisappearsIsMade) {
    const TemporaryFolder folder;
    write_bytes(folder / "a", "old");
    OutputSet set;
    set.stage(folder / "a", "new");
    std::filesystem::remove(folder / "a");
    set.commit(true);
    EXPECT_EQ(bytes_of(folder / "a"), "new");
}

/// A set of a case folder, of a file in the same folder above it, and of one in a deeper folder.
class CaseFolder {
   public:
    CaseFolder() {
        set_.stage_folder(folder / "cases/c");
        for (const char* name : {"cases/c/x/a", "cases/c/y/deep/b", "cases/table", "plain"}) {
            set_.stage(folder / name, "new");
        }
    }
    void expect_new() const {
        for (const char* name : {"cases/c/x/a", "cases/c/y/deep/b", "cases/table", "plain"}) {
            EXPECT_EQ(bytes_of(folder / name), "new") << name;
        }
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "")) {
            EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
        }
    }
    void commit(bool force) { set_.commit(force); }
    /// Makes a file as another run does.
    void meanwhile(const std::string& name) {
        std::filesystem::create_directories(std::filesystem::path(folder / name).parent_path());
        write_bytes(folder / name, "meanwhile");
    }

    TemporaryFolder folder;

   private:
    OutputSet set_;
};

TEST(Meanwhile, AFolderThatAppearsTakesTheFilesOneByOne) {
    for (const bool force : {false, true}) {
        CaseFolder set;
        set.meanwhile("cases/mine");
        set.commit(force);
        set.expect_new();
        EXPECT_EQ(bytes_of(set.folder / "cases/mine"), "meanwhile");
    }
}

TEST(Meanwhile, FilesInACaseFolderThatAppearsAreReplacedWithForce) {
    for (const char* name : {"cases/c/x/a", "cases/c/y/deep/b", "cases/c/y/mine", "cases/table"}) {
        CaseFolder set;
        set.meanwhile(name);
        set.commit(true);
        set.expect_new();
    }
}

TEST(Meanwhile, ACaseFolderThatAppearsStaysWithoutForce) {
    CaseFolder set;
    set.meanwhile("cases/c/x/a");
    EXPECT_THROW(set.commit(false), OutputExists);
    EXPECT_EQ(bytes_of(set.folder / "cases/c/x/a"), "meanwhile");
    EXPECT_FALSE(std::filesystem::exists(set.folder / "plain"));
}

}  // namespace
}  // namespace pcvt
