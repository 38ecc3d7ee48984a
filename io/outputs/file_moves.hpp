#pragma once

#include <set>
#include <string>
#include <vector>

#include "io/outputs/file_calls.hpp"

namespace pcvt {

/// One staged file, or one staged folder, and the name that it gets.
///
/// The names that exist are the state of the move, so that a process that finds them needs no other
/// record:
///   waiting   `temporary` exists; `target` is the old file, or is missing
///   kept      the same, and `backup` is a second name of the old file
///   done      `temporary` is missing; `target` is the new file
/// A move back passes through the same states in the reverse order.
struct FileMove {
    enum class Kind { kNewFile, kReplacement, kNewFolder };
    Kind kind = Kind::kNewFile;
    std::string temporary;
    /// Empty except for a replacement.
    std::string backup;
    std::string target;
    FileStamp fresh;
    FileStamp old;
};

/// Moves all files of a set to their targets, or all of them back.
///
/// Nothing here allocates or throws once it is constructed, so that no lack of memory can stop a
/// move half way. No old file loses its last name before remove_backups().
///
/// Example usage:
///     FileMoves moves(std::move(list), staging_folders);
///     FileMoves::Fault fault = moves.put_all();
///     if (fault.error == 0) moves.remove_backups();
///     else moves.take_all_back();
class FileMoves {
   public:
    struct Fault {
        int error = 0;
        /// The path that is at fault.
        const char* path = "";
    };

    /// @param staging  the folders that hold the temporary files.
    FileMoves(std::vector<FileMove> moves, std::set<std::string> staging);

    /// Whether nobody else has changed the files of the moves that are not done yet.
    bool can_be_completed() const noexcept;
    /// Moves every file that is not done, and waits until the names are on the disk.
    Fault put_all() noexcept;
    /// Restores all targets. Tries each move several times. A target that somebody else has written
    /// since stays as it is.
    Fault take_all_back() noexcept;
    /// Removes the last names of the old files, and waits until that is on the disk.
    Fault remove_backups() noexcept;
    /// Waits until the names in all folders are on the disk.
    Fault sync_folders() noexcept;

    const std::vector<FileMove>& moves() const { return moves_; }

   private:
    std::vector<FileMove> moves_;
    /// The folders in which names change.
    std::set<std::string> folders_;
};

}  // namespace pcvt
