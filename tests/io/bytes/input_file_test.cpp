#include "io/bytes/input_file.hpp"

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "tests/support/damaged_text.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;

/// Returns the refusal of a file, or an empty string if it can be read.
std::string fault(const std::string& path) {
    return testing::fault_in([&] { read_whole_file(path); });
}

TEST(InputFile, UnreadableFilesAreRefusedWithTheReason) {
    const testing::TemporaryFolder folder;
    EXPECT_EQ(fault(folder / "none"),
              (folder / "none") + ": cannot read: No such file or directory; give a readable file");
    EXPECT_THAT(fault(folder / ""), HasSubstr("cannot read: it is a folder; give a regular file"));
    EXPECT_THAT(fault("-"), HasSubstr("-: cannot read: No such file"));
}

TEST(InputFile, AFileComesBackByteForByte) {
    const testing::TemporaryFolder folder;
    std::string bytes(200'000, '\0');
    for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<char>(k * k >> 3);
    testing::write_bytes(folder / "f", bytes);
    EXPECT_EQ(read_whole_file(folder / "f"), bytes);
    testing::write_bytes(folder / "empty", "");
    EXPECT_EQ(read_whole_file(folder / "empty"), "");
}

TEST(InputFile, AFileHoldsItsBytesAndNoOthers) {
    const testing::TemporaryFolder folder;
    const std::string bytes(200'000, 'x');
    testing::write_bytes(folder / "f", bytes);
    EXPECT_TRUE(file_holds(folder / "f", bytes));
    EXPECT_FALSE(file_holds(folder / "f", bytes.substr(1)));
    EXPECT_FALSE(file_holds(folder / "f", bytes + 'x'));
    EXPECT_FALSE(file_holds(folder / "f", ""));
    for (const std::size_t k : {0U, 65'535U, 65'536U, 199'999U}) {
        std::string other = bytes;
        other[k] = 'y';
        EXPECT_FALSE(file_holds(folder / "f", other)) << k;
    }
    EXPECT_THROW(file_holds(folder / "none", ""), BadFile);
}

/// Makes a name of a socket in the file system.
void bind_socket(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    const int file = socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(bind(file, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    close(file);
}

TEST(InputFile, OnlyRegularFilesAreReadAndNoOthersWaitedFor) {
    const testing::TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
    bind_socket(folder / "socket");
    std::filesystem::create_symlink("fifo", folder / "link");
    EXPECT_EQ(fault(folder / "fifo"),
              (folder / "fifo") + ": cannot read: it is a pipe; give a regular file");
    EXPECT_THAT(fault(folder / "link"), HasSubstr("it is a pipe"));
    EXPECT_THAT(fault(folder / "socket"), HasSubstr("it is a socket"));
    EXPECT_THAT(fault("/dev/zero"), HasSubstr("it is a device"));
    EXPECT_THAT(fault("/dev/null"), HasSubstr("it is a device"));
}

TEST(InputFile, IsReadUpToItsLimit) {
    const testing::TemporaryFolder folder;
    const InputLimit limit{1000, "1000 bytes", "give less", false};
    testing::write_bytes(folder / "f", std::string(1000, 'x'));
    EXPECT_EQ(read_whole_file(folder / "f", limit).size(), 1000U);
    testing::write_bytes(folder / "f", std::string(1001, 'x'));
    try {
        read_whole_file(folder / "f", limit);
        FAIL();
    } catch (const LimitExceeded& exceeded) {
        EXPECT_EQ(exceeded.what(),
                  (folder / "f") + ": more than 1000 bytes, the most that is read; give less");
    }
    // A file of /proc states no size.
    EXPECT_THAT(read_whole_file("/proc/self/status"), HasSubstr("Pid:"));
}

TEST(InputFile, ATextIsNotReadBehindItsFirstNulByte) {
    const testing::TemporaryFolder folder;
    testing::write_bytes(folder / "f", "1 2\n");
    std::filesystem::resize_file(folder / "f", std::uintmax_t(1) << 33);
    EXPECT_LT(read_whole_file(folder / "f", kSiteInput).size(), 1U << 20);
    EXPECT_THROW(read_whole_file(folder / "f", kTileInput), LimitExceeded);
}

}  // namespace
}  // namespace pcvt
