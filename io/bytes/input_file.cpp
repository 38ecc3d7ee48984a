#include "io/bytes/input_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <vector>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr const char* kStandardInputName = "standard input";

[[noreturn]] void throw_unreadable(const std::string& name, const std::string& reason,
                                   const std::string& remedy = "give a readable file") {
    throw UnusableFile(name + ": cannot read: " + reason + "; " + remedy);
}

[[noreturn]] void throw_unreadable(const std::string& name, int error) {
    throw_unreadable(name, std::generic_category().message(error));
}

[[noreturn]] void throw_too_large(const std::string& name, const InputLimit& limit) {
    throw LimitExceeded(name + ": more than " + limit.words + ", the most that is read; " +
                        limit.remedy);
}

const char* kind_of(const struct stat& status) {
    if (S_ISDIR(status.st_mode)) return "it is a folder";
    if (S_ISFIFO(status.st_mode)) return "it is a pipe";
    if (S_ISSOCK(status.st_mode)) return "it is a socket";
    return "it is a device";
}

/// Reads a file block by block from its beginning to its end, and closes it unless it is standard
/// input.
class BlockReader {
   public:
    BlockReader(const std::string& name, int file) : name_(name), file_(file), block_(1 << 16) {}
    ~BlockReader() {
        if (file_ != STDIN_FILENO) ::close(file_);
    }
    BlockReader(const BlockReader&) = delete;
    BlockReader& operator=(const BlockReader&) = delete;

    /// Returns the next bytes, which are valid until the next call; empty at the end of the file.
    std::string_view next() {
        while (true) {
            checkpoint();
            const ssize_t n = ::read(file_, block_.data(), block_.size());
            if (n >= 0) return {block_.data(), static_cast<std::size_t>(n)};
            if (errno != EINTR) throw_unreadable(name_, errno);
        }
    }

   private:
    const std::string& name_;
    int file_;
    std::vector<char> block_;
};

/// The one place that opens a file for reading. A file that is not regular is not even opened,
/// because opening it can already have an effect on a device; without O_NONBLOCK the call would
/// wait for the other end of a pipe that takes the place of the file between the two calls.
int open_regular_file(const std::string& path, std::uint64_t& size) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) throw_unreadable(path, errno);
    const char* remedy = "give a regular file";
    if (!S_ISREG(status.st_mode)) throw_unreadable(path, kind_of(status), remedy);
    int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (file == STDIN_FILENO) {
        file = ::fcntl(file, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
        ::close(STDIN_FILENO);
    }
    if (file < 0) throw_unreadable(path, errno);
    const int error = ::fstat(file, &status) != 0 ? errno : 0;
    if (error != 0 || !S_ISREG(status.st_mode)) ::close(file);
    if (error != 0) throw_unreadable(path, error);
    if (!S_ISREG(status.st_mode)) throw_unreadable(path, kind_of(status), remedy);
    size = static_cast<std::uint64_t>(status.st_size);
    return file;
}

/// Appends the rest of a file, whose size is only a hint: it may grow meanwhile.
std::string read_all(const std::string& name, int file, const InputLimit& limit,
                     std::uint64_t size) {
    BlockReader reader(name, file);
    if (size > limit.bytes) throw_too_large(name, limit);
    std::string bytes;
    if (!limit.ends_at_nul) bytes.reserve(static_cast<std::size_t>(size));
    for (std::string_view block = reader.next(); !block.empty(); block = reader.next()) {
        if (bytes.size() + block.size() > limit.bytes) throw_too_large(name, limit);
        bytes += block;
        if (limit.ends_at_nul && block.find('\0') != std::string_view::npos) break;
    }
    return bytes;
}

}  // namespace

std::string read_whole_file(const std::string& path, const InputLimit& limit) {
    std::uint64_t size = 0;
    const int file = open_regular_file(path, size);
    return read_all(path, file, limit, size);
}

std::string read_standard_input() {
    return read_all(kStandardInputName, STDIN_FILENO, kStandardInput, 0);
}

bool file_holds(const std::string& path, std::string_view bytes) {
    std::uint64_t size = 0;
    BlockReader reader(path, open_regular_file(path, size));
    if (size != bytes.size()) return false;
    for (std::string_view block = reader.next(); !block.empty(); block = reader.next()) {
        if (!bytes.starts_with(block)) return false;
        bytes.remove_prefix(block.size());
    }
    return bytes.empty();
}

}  // namespace pcvt
