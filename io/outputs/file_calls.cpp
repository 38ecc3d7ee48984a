#include "io/outputs/file_calls.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "io/outputs/free_name.hpp"

namespace pcvt {
namespace {

/// Returns the descriptor, or a copy of it above the three standard ones.
int above_standard(int file) {
    if (file < 0 || file > STDERR_FILENO) return file;
    const int copy = ::fcntl(file, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    const int error = errno;
    ::close(file);
    errno = error;
    return copy;
}

int error_of(int result) { return result == 0 ? 0 : errno; }

int open_regular(const char* path, int access, int& file) {
    file = above_standard(::open(path, access | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    if (file < 0) return errno;
    struct stat status {};
    const int error = ::fstat(file, &status) != 0 ? errno : S_ISREG(status.st_mode) ? 0 : EINVAL;
    if (error != 0) close_file(file);
    return error;
}

/// Whether an error says that the file system lacks a call.
bool is_missing_call(int error) { return error == EINVAL || error == ENOSYS; }

}  // namespace

int look_up(const char* path, NameStatus& status) noexcept {
    struct stat found {};
    status = {};
    if (::lstat(path, &found) != 0) return errno == ENOENT || errno == ENOTDIR ? 0 : errno;
    status.exists = true;
    status.is_folder = S_ISDIR(found.st_mode);
    status.stamp = {found.st_size, found.st_mtim.tv_sec, found.st_mtim.tv_nsec};
    status.device = found.st_dev;
    status.inode = found.st_ino;
    return 0;
}

int create_file(const char* path, int& file) noexcept {
    file = above_standard(::open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    return file < 0 ? errno : 0;
}

int open_file(const char* path, int& file) noexcept { return open_regular(path, O_RDWR, file); }

int open_lock_file(const char* path, int& file, bool& is_fresh) noexcept {
    int error = EEXIST;
    // Another run may make or remove the file between the two calls.
    while (error == EEXIST) {
        error = open_regular(path, O_RDWR, file);
        if (error == EACCES) error = open_regular(path, O_RDONLY, file);
        if (error != ENOENT) break;
        error = create_file(path, file);
        is_fresh = error == 0;
    }
    return error;
}

bool is_of_this_user(int file) noexcept {
    struct stat status {};
    return ::fstat(file, &status) == 0 && status.st_uid == ::geteuid();
}

int try_lock(int file) noexcept {
    struct stat status {};
    if (::flock(file, LOCK_EX | LOCK_NB) != 0 || ::fstat(file, &status) != 0) return errno;
    // A run that found the file before it was locked may have removed it.
    return status.st_nlink > 0 ? 0 : EWOULDBLOCK;
}

void unlock(int file) noexcept { ::flock(file, LOCK_UN); }

bool lacks_locks(int error) noexcept {
    return error == ENOSYS || error == ENOTSUP || error == ENOLCK || error == EINVAL;
}

void close_file(int& file) noexcept {
    if (file >= 0) ::close(std::exchange(file, -1));
}

int write_all(int file, std::string_view bytes) noexcept {
    while (!bytes.empty()) {
        const ssize_t n = ::write(file, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return n < 0 ? errno : EIO;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
}

int sync_file(int file) noexcept {
    // Some special file systems cannot synchronise; they report EINVAL or ENOTSUP.
    if (::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP) return 0;
    return errno;
}

int sync_folder(const char* path) noexcept {
    const int folder = above_standard(::open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder < 0) return errno == EACCES || errno == EPERM ? 0 : errno;
    const int error = sync_file(folder);
    ::close(folder);
    return error;
}

int overwrite(int file, std::string_view bytes) noexcept {
    if (::ftruncate(file, 0) != 0 || ::lseek(file, 0, SEEK_SET) != 0) return errno;
    const int error = write_all(file, bytes);
    return error != 0 ? error : sync_file(file);
}

int move_file_to_free_name(const char* from, const char* to) noexcept {
    if (rename_to_free_name(from, to) == 0) return 0;
    if (errno != EEXIST && !is_missing_call(errno)) return errno;
    // The file system lacks this rename, or the name is taken, perhaps by the other link that an
    // earlier pair of link and unlink left. A hard link does not replace an existing file either.
    if (errno != EEXIST && ::link(from, to) == 0) return remove_name(from);
    const int error = errno;
    NameStatus source;
    NameStatus target;
    if (error != EEXIST || look_up(from, source) != 0 || look_up(to, target) != 0) return error;
    return source.is_same_file(target) ? remove_name(from) : error;
}

int move_folder_to_free_name(const char* from, const char* to) noexcept {
    if (rename_to_free_name(from, to) == 0) return 0;
    if (!is_missing_call(errno)) return errno;
    // Where the file system lacks this rename, an empty folder is replaced.
    return error_of(::rename(from, to));
}

int remove_name(const char* path) noexcept {
    return ::unlink(path) == 0 || errno == ENOENT ? 0 : errno;
}

std::string reason_of(int error) { return std::generic_category().message(error); }

}  // namespace pcvt
