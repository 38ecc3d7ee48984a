#include "io/bytes/output.hpp"

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

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

/// Keeps a temporary name below 255 bytes, the longest name of a file.
constexpr std::size_t kLongestStem = 200;

[[noreturn]] void throw_unwritable(const std::string& path, const std::string& reason) {
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

/// Returns the folder of `path`, or the nearest folder above it if that one is missing. A folder
/// that cannot be examined is returned, so that its use reports the reason.
std::string existing_folder_of(const std::string& path) {
    std::string folder = folder_of(path);
    struct stat status {};
    while (folder != "." && ::lstat(folder.c_str(), &status) != 0 &&
           (errno == ENOENT || errno == ENOTDIR)) {
        folder = folder_of(folder);
    }
    return folder;
}

/// Returns six letters and digits that differ from all recent results in this process.
std::string fresh_suffix() {
    static std::atomic<std::uint64_t> counter{static_cast<std::uint64_t>(::getpid()) * 0x9E3779B9U};
    constexpr std::string_view letters = "0123456789abcdefghijklmnopqrstuvwxyz";
    std::uint64_t value = counter.fetch_add(1);
    std::string suffix;
    for (int k = 0; k < 6; ++k, value /= letters.size()) suffix += letters[value % letters.size()];
    return suffix;
}

/// Returns a name on the file system of `path`, below no folder that is missing.
std::string temporary_name(const std::string& path) {
    const std::string name = std::filesystem::path(path).filename().string();
    return existing_folder_of(path) + "/." + name.substr(0, kLongestStem) + ".pcvt-" +
           fresh_suffix();
}

/// Creates and opens a new file. mkstemp() will not do: its mode 0600 could be widened to the
/// permissions of the umask only by setting the umask of the whole process for a moment.
int create_temporary(const std::string& path, std::string& temporary) {
    while (true) {
        temporary = temporary_name(path);
        const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) return file;
        if (errno != EEXIST) throw_unwritable(path, reason_of(errno));
    }
}

/// Creates and opens `temporary` in a folder under a hidden name, where no other file can be.
int create_new(const std::string& path, const std::string& temporary) {
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) throw_unwritable(path, reason_of(errno));
    return file;
}

/// Creates `innermost` with all missing folders above it, and appends them to `created`.
void make_folders(const std::string& innermost, std::vector<std::string>& created) {
    struct stat status {};
    if (::stat(innermost.c_str(), &status) == 0) return;
    if (const std::string above = folder_of(innermost); above != innermost) {
        make_folders(above, created);
    }
    if (::mkdir(innermost.c_str(), 0777) == 0) {
        created.push_back(innermost);
    } else if (errno != EEXIST) {
        throw OutputError(innermost + ": cannot make the folder: " + reason_of(errno));
    }
}

/// Removes folders in the reverse order. Keeps folders into which somebody else has put a file.
void remove_folders(const std::vector<std::string>& created) {
    for (auto path = created.rbegin(); path != created.rend(); ++path) ::rmdir(path->c_str());
}

/// Returns 0, or the error that stopped the writing.
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = ::write(file, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return n < 0 ? errno : EIO;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return 0;
}

/// Returns 0, or the error. Some pipes and special file systems cannot sync; they report EINVAL or
/// ENOTSUP.
int sync(int file) {
    if (::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP) return 0;
    return errno;
}

/// Moves a file to a name that must be free. Returns 0, or the error.
int rename_to_free_name(const std::string& from, const std::string& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
    if (errno != EINVAL && errno != ENOSYS) return errno;
    // The file system lacks this rename. A hard link does not replace an existing file either.
    if (::link(from.c_str(), to.c_str()) != 0) return errno;
    ::unlink(from.c_str());
    return 0;
}

/// The same for folders; an empty folder is replaced where the file system lacks this rename.
int rename_folder(const std::string& from, const std::string& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
    if (errno != EINVAL && errno != ENOSYS) return errno;
    return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

/// Gives the file at `target` a second name, so that it can be restored. Returns 0, or the error.
int keep(const std::string& target, const std::string& backup) {
    struct stat status {};
    if (::lstat(target.c_str(), &status) != 0) return errno;
    if (S_ISDIR(status.st_mode)) return EISDIR;
    if (::link(target.c_str(), backup.c_str()) == 0) return 0;
    // Hard links are not supported, or not permitted to another user's file: rename it instead.
    return ::rename(target.c_str(), backup.c_str()) == 0 ? 0 : errno;
}

}  // namespace

OutputSet::~OutputSet() { remove_staged(); }

void OutputSet::remove_staged() {
    for (const Staged& file : staged_) ::unlink(file.temporary.c_str());
    for (const Folder& folder : folders_) remove_folders(folder.created);
}

void OutputSet::require_writable(const std::string& path, bool force) {
    struct stat status {};
    if (path.empty() || path.back() == '/') throw_unwritable(path, "the path has no file name");
    if (::lstat(path.c_str(), &status) == 0) {
        if (::stat(path.c_str(), &status) == 0) {
            if (S_ISDIR(status.st_mode)) throw_unwritable(path, reason_of(EISDIR));
            if (!S_ISREG(status.st_mode)) throw_unwritable(path, "it is not a regular file");
        }
        if (!force) refuse_existing(path);
    }
    const std::string folder = existing_folder_of(path);
    if (::stat(folder.c_str(), &status) != 0)
        throw_unwritable(path, "folder " + folder + ": " + reason_of(errno));
    if (!S_ISDIR(status.st_mode))
        throw_unwritable(path, "folder " + folder + ": " + reason_of(ENOTDIR));
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        throw_unwritable(path, "folder " + folder + ": " + reason_of(errno));
    }
}

void OutputSet::require_writable_folder(const std::string& folder,
                                        const std::vector<std::string>& paths, bool force) {
    struct stat status {};
    if (::lstat(folder.c_str(), &status) != 0) {
        require_writable(folder, force);
        return;
    }
    if (::stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) {
        throw_unwritable(folder, "it exists and is not a folder; choose another name");
    }
    if (!force) throw_unwritable(folder, "it exists; use --force to replace the files in it");
    for (const std::string& path : paths) {
        require_writable(path, force);
    }
}

void OutputSet::stage_folder(const std::string& folder) {
    const std::lock_guard lock(mutex_);
    folders_.push_back({folder, {}, {}});
    struct stat status {};
    if (::lstat(folder.c_str(), &status) == 0) return;
    Folder& entry = folders_.back();
    do {
        entry.temporary = temporary_name(folder);
        if (::mkdir(entry.temporary.c_str(), 0777) == 0) {
            entry.created.push_back(entry.temporary);
        } else if (errno != EEXIST) {
            throw_unwritable(folder, reason_of(errno));
        }
    } while (entry.created.empty());
}

/// Creates and opens the temporary file that replaces `path` in commit().
int OutputSet::create(const std::string& path) {
    const std::lock_guard lock(mutex_);
    Staged entry{path, {}, {}};
    for (Folder& folder : folders_) {
        if (!path.starts_with(folder.target + "/")) continue;
        entry.moves_with_folder = !folder.temporary.empty();
        if (entry.moves_with_folder) {
            entry.temporary = folder.temporary + path.substr(folder.target.size());
        }
        make_folders(folder_of(entry.moves_with_folder ? entry.temporary : path), folder.created);
    }
    const int file = entry.moves_with_folder ? create_new(path, entry.temporary)
                                             : create_temporary(path, entry.temporary);
    staged_.push_back(entry);
    return file;
}

void OutputSet::stage(const std::string& path, const std::string& bytes) {
    const int file = create(path);
    int error = write_all(file, bytes);
    if (error == 0) error = sync(file);
    if (::close(file) != 0 && error == 0) error = errno;
    if (error != 0) throw_unwritable(path, reason_of(error));
}

bool OutputSet::holds(const std::string& path, std::string_view bytes) const {
    std::string temporary;
    {
        const std::lock_guard lock(mutex_);
        for (const Staged& file : staged_) {
            if (file.target == path) temporary = file.temporary;
        }
    }
    if (!temporary.empty()) return file_holds(temporary, bytes);
    throw InternalError(path + " was read back before it was staged");
}

void OutputSet::put(Staged& file, bool force) {
    if (force) {
        const std::string backup = temporary_name(file.target);
        const int error = keep(file.target, backup);
        if (error == 0) file.backup = backup;
        if (error != 0 && error != ENOENT) throw_unwritable(file.target, reason_of(error));
        if (::rename(file.temporary.c_str(), file.target.c_str()) != 0) {
            throw_unwritable(file.target, reason_of(errno));
        }
    } else if (const int error = rename_to_free_name(file.temporary, file.target)) {
        if (error == EEXIST) refuse_existing(file.target);
        throw_unwritable(file.target, reason_of(error));
    }
}

void OutputSet::put_all(bool force, std::size_t& n_put) {
    for (; n_put < staged_.size(); ++n_put) {
        if (staged_[n_put].moves_with_folder) continue;
        make_folders(folder_of(staged_[n_put].target), made_);
        put(staged_[n_put], force);
    }
    for (Folder& folder : folders_) {
        if (folder.temporary.empty()) continue;
        make_folders(folder_of(folder.target), made_);
        if (const int error = rename_folder(folder.temporary, folder.target)) {
            throw_unwritable(folder.target, error == EEXIST ? "it exists; use --force to replace it"
                                                            : reason_of(error));
        }
        folder.moved = true;
    }
}

void OutputSet::take_back(std::size_t n_put) {
    for (const Folder& folder : folders_) {
        if (folder.moved) ::rename(folder.target.c_str(), folder.temporary.c_str());
    }
    for (std::size_t k = 0; k < staged_.size(); ++k) {
        const Staged& file = staged_[k];
        if (!file.backup.empty()) {
            ::rename(file.backup.c_str(), file.target.c_str());
            // rename() does nothing where both names belong to one file.
            ::unlink(file.backup.c_str());
        } else if (k < n_put && !file.moves_with_folder) {
            ::unlink(file.target.c_str());
        }
    }
}

void OutputSet::commit(bool force) {
    std::size_t n_put = 0;
    try {
        put_all(force, n_put);
    } catch (const OutputError&) {
        take_back(n_put);
        remove_folders(made_);
        throw;
    }
    for (const Staged& file : staged_) {
        if (!file.backup.empty()) ::unlink(file.backup.c_str());
    }
    staged_.clear();
    folders_.clear();
    made_.clear();
}

}  // namespace pcvt
