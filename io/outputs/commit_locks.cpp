#include "io/outputs/commit_locks.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "io/outputs/file_calls.hpp"
#include "io/outputs/writable_paths.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr std::string_view kLock = ".pcvt-lock";
/// A commit of a few files takes some milliseconds.
constexpr std::chrono::milliseconds kBetweenAttempts{5};

/// Whether an error says that a lock cannot be had here by any run of this user.
bool is_without_locks(int error) {
    return lacks_locks(error) || error == EACCES || error == EPERM || error == EROFS ||
           error == EBADF || error == ELOOP || error == EISDIR || error == ENXIO;
}

std::string waiting_words(const std::string& folder) {
    return "waiting for another run that writes to " +
           (folder == "." ? "the current folder" : folder);
}

}  // namespace

bool is_commit_lock(std::string_view leaf) { return leaf.starts_with(kLock); }

void remove_stale_lock(const std::string& folder) noexcept {
    try {
        CommitLocks lock;
        lock.try_take({folder});
    } catch (...) {
        // It stays for the next run.
    }
}

CommitLocks::Lock::Lock(const std::string& folder) : path((folder + "/").append(kLock)) {
    // In a folder such as /tmp only the owner of a file may replace it: each user has a lock there.
    struct stat status {};
    is_of_one_user = ::stat(folder.c_str(), &status) == 0 && (status.st_mode & S_ISVTX) != 0;
    if (is_of_one_user) path += "-" + std::to_string(::geteuid());
}

/// Makes one attempt. Returns false if another set holds the lock.
bool CommitLocks::Lock::acquire() {
    bool is_fresh = false;
    int error = open_lock_file(path.c_str(), file, is_fresh);
    if (error == 0 && is_of_one_user && !is_of_this_user(file)) error = EPERM;
    if (error == 0) error = try_lock(file);
    if (error == 0) return true;
    if (is_fresh && error != EWOULDBLOCK) remove_name(path.c_str());
    close_file(file);
    if (error == EWOULDBLOCK) return false;
    if (!is_without_locks(error)) throw_unwritable(path, reason_of(error));
    return true;
}

CommitLocks::~CommitLocks() { release(); }

CommitLocks::Folders CommitLocks::identified(const std::set<std::string>& folders) {
    Folders found;
    for (const std::string& folder : folders) {
        struct stat status {};
        // The commit reports a folder that is missing.
        if (::stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) continue;
        found.emplace(std::pair(status.st_dev, status.st_ino), folder);
    }
    return found;
}

void CommitLocks::take(const std::set<std::string>& folders, const WaitingCallback& waiting) {
    release();
    folders_ = identified(folders);
    for (const auto& [identity, folder] : folders_) {
        // Listed first, because a lock without an entry would be left behind if memory ran out.
        locks_.emplace_back(folder);
        bool is_reported = false;
        while (!locks_.back().acquire()) {
            if (waiting && !is_reported) waiting(waiting_words(folder));
            is_reported = true;
            checkpoint();
            std::this_thread::sleep_for(kBetweenAttempts);
        }
    }
}

bool CommitLocks::try_take(const std::set<std::string>& folders) {
    release();
    folders_ = identified(folders);
    for (const auto& [identity, folder] : folders_) {
        locks_.emplace_back(folder);
        if (locks_.back().acquire()) continue;
        release();
        return false;
    }
    return true;
}

bool CommitLocks::are_of(const std::set<std::string>& folders) const {
    return folders_ == identified(folders);
}

void CommitLocks::release() noexcept {
    for (Lock& lock : locks_) {
        if (lock.file < 0) continue;
        remove_name(lock.path.c_str());
        // A process that was forked meanwhile shares the file and would keep the lock.
        unlock(lock.file);
        close_file(lock.file);
    }
    locks_.clear();
    folders_.clear();
}

}  // namespace pcvt
