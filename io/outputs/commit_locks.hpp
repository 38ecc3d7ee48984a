#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pcvt {

/// Called when a set begins to wait, with the words for it: "waiting for another run that writes to
/// out".
using WaitingCallback = std::function<void(const std::string& words)>;

/// The locks of the folders in which a set changes files, so that the sets of several runs, threads
/// and hosts are committed one after the other.
///
/// Each lock is a hidden file of the folder, which is removed when the lock is released. The system
/// releases it when the process ends, in any way; the next run then takes over the file that is
/// left. Locks are taken in one order for all sets, that of the folders' identities, so that no two
/// sets wait for each other. A folder whose lock cannot be had counts as locked: the file system
/// has no locks, or the file belongs to another user.
///
/// Example usage:
///     CommitLocks locks;
///     locks.take({"out", "."}, {});  // waits; calls checkpoint()
///     move_files();
///     locks.release();
class CommitLocks {
   public:
    CommitLocks() = default;
    ~CommitLocks();
    CommitLocks(const CommitLocks&) = delete;
    CommitLocks& operator=(const CommitLocks&) = delete;

    /// Waits until no other set holds one of the folders.
    /// @param waiting  may be empty.
    /// @throws Cancelled; OutputError with path and reason.
    void take(const std::set<std::string>& folders, const WaitingCallback& waiting);
    /// Takes the locks if none of them is held. Returns whether they are taken.
    /// @throws OutputError with path and reason.
    bool try_take(const std::set<std::string>& folders);
    /// Whether the locks are those of these folders, none of which has been replaced since.
    bool are_of(const std::set<std::string>& folders) const;
    void release() noexcept;

   private:
    struct Lock {
        explicit Lock(const std::string& folder);
        std::string path;
        /// Whether a file of another user does not count as a lock.
        bool is_of_one_user = false;
        /// -1: not held.
        int file = -1;
        bool acquire();
    };
    /// Folders by device and inode.
    using Folders = std::map<std::pair<unsigned long long, unsigned long long>, std::string>;
    static Folders identified(const std::set<std::string>& folders);

    Folders folders_;
    std::vector<Lock> locks_;
};

/// Whether a name in a folder is that of the lock of its commits.
bool is_commit_lock(std::string_view leaf);
/// Removes the lock of a process that was killed.
void remove_stale_lock(const std::string& folder) noexcept;

}  // namespace pcvt
