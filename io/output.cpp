#include "io/output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "io/text.hpp"

namespace pcvt {
namespace {

/// Keeps the temporary name under the 255 bytes of a folder's entry.
constexpr std::size_t kLongestStem = 200;

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
    throw OutputError(path + ": cannot write: " + reason);
}

[[noreturn]] void refuse_existing(const std::string& path) {
    throw OutputExists(path + ": cannot write: it exists");
}

std::string reason_of(int error) { return std::generic_category().message(error); }

std::string folder_of(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

/// Six letters and digits that no other call of this process has had lately.
std::string fresh_suffix() {
    static std::atomic<std::uint64_t> counter{static_cast<std::uint64_t>(::getpid()) * 0x9E3779B9U};
    constexpr std::string_view letters = "0123456789abcdefghijklmnopqrstuvwxyz";
    std::uint64_t value = counter.fetch_add(1);
    std::string suffix;
    for (int k = 0; k < 6; ++k, value /= letters.size()) suffix += letters[value % letters.size()];
    return suffix;
}

std::string temporary_name(const std::string& path) {
    const std::string name = std::filesystem::path(path).filename().string();
    return folder_of(path) + "/." + name.substr(0, kLongestStem) + ".pcvt-" + fresh_suffix();
}

/// Creates and opens a file that was not there. Not mkstemp: its 0600 could be widened to what the
/// umask allows only by setting the umask of the whole process for a moment.
int create_temporary(const std::string& path, std::string& temporary) {
    while (true) {
        temporary = temporary_name(path);
        const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) return file;
        if (errno != EEXIST) refuse(path, reason_of(errno));
    }
}

/// 0, or the error that stopped it.
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(file, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return n < 0 ? errno : EIO;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
}

/// Some pipes and special file systems cannot sync; they say so with EINVAL or ENOTSUP.
int sync(int file) {
    if (::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP) return 0;
    return errno;
}

/// Moves a file to a name that must be free. 0, or the error.
int rename_to_free_name(const std::string& from, const std::string& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
    if (errno != EINVAL && errno != ENOSYS) return errno;
    // The file system knows no such rename: a second name does not replace either.
    if (::link(from.c_str(), to.c_str()) != 0) return errno;
    ::unlink(from.c_str());
    return 0;
}

/// Gives what stands at `target` a second name, so that it can come back. 0, or the error.
int keep(const std::string& target, const std::string& backup) {
    struct stat status {};
    if (::lstat(target.c_str(), &status) != 0) return errno;
    if (S_ISDIR(status.st_mode)) return EISDIR;
    if (::link(target.c_str(), backup.c_str()) == 0) return 0;
    // No hard links here, or not to a file of somebody else: move it aside.
    return ::rename(target.c_str(), backup.c_str()) == 0 ? 0 : errno;
}

}  // namespace

OutputSet::~OutputSet() {
    for (const Staged& file : staged_) ::unlink(file.temporary.c_str());
}

void OutputSet::require_writable(const std::string& path, bool force) {
    struct stat status {};
    if (path.empty() || path.back() == '/') refuse(path, "a file name is missing");
    if (::lstat(path.c_str(), &status) == 0) {
        if (::stat(path.c_str(), &status) == 0) {
            if (S_ISDIR(status.st_mode)) refuse(path, reason_of(EISDIR));
            if (!S_ISREG(status.st_mode)) refuse(path, "it is not an ordinary file");
        }
        if (!force) refuse_existing(path);
    }
    const std::string folder = folder_of(path);
    if (::stat(folder.c_str(), &status) != 0)
        refuse(path, "folder " + folder + ": " + reason_of(errno));
    if (!S_ISDIR(status.st_mode)) refuse(path, "folder " + folder + ": " + reason_of(ENOTDIR));
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        refuse(path, "folder " + folder + ": " + reason_of(errno));
    }
}

void OutputSet::stage(const std::string& path, const std::string& bytes) {
    Staged entry{path, {}, {}};
    const int file = create_temporary(path, entry.temporary);
    staged_.push_back(entry);
    int error = write_all(file, bytes);
    if (error == 0) error = sync(file);
    if (::close(file) != 0 && error == 0) error = errno;
    if (error != 0) refuse(path, reason_of(error));
}

std::string OutputSet::read_back(const std::string& path) const {
    for (const Staged& file : staged_) {
        if (file.target == path) return read_whole_file(file.temporary);
    }
    throw InternalError(path + " was read back before it was staged");
}

void OutputSet::put(Staged& file, bool force) {
    if (force) {
        const std::string backup = temporary_name(file.target);
        const int error = keep(file.target, backup);
        if (error == 0) file.backup = backup;
        if (error != 0 && error != ENOENT) refuse(file.target, reason_of(error));
        if (::rename(file.temporary.c_str(), file.target.c_str()) != 0) {
            refuse(file.target, reason_of(errno));
        }
    } else if (const int error = rename_to_free_name(file.temporary, file.target)) {
        if (error == EEXIST) refuse_existing(file.target);
        refuse(file.target, reason_of(error));
    }
}

void OutputSet::commit(bool force) {
    std::size_t n_put = 0;
    try {
        for (; n_put < staged_.size(); ++n_put) put(staged_[n_put], force);
    } catch (const OutputError&) {
        for (std::size_t k = 0; k < staged_.size(); ++k) {
            const Staged& file = staged_[k];
            if (!file.backup.empty()) {
                ::rename(file.backup.c_str(), file.target.c_str());
                // Between two names of one file, rename does nothing.
                ::unlink(file.backup.c_str());
            } else if (k < n_put) {
                ::unlink(file.target.c_str());
            }
        }
        throw;
    }
    for (const Staged& file : staged_) {
        if (!file.backup.empty()) ::unlink(file.backup.c_str());
    }
    staged_.clear();
}

}  // namespace pcvt
