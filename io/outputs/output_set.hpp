#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/encoded_file.hpp"
#include "io/outputs/commit_locks.hpp"
#include "io/outputs/file_moves.hpp"
#include "io/outputs/journal.hpp"
#include "io/outputs/staging.hpp"

namespace pcvt {

/// Writes files, and folders of files, that appear together and complete, or not at all.
///
/// stage() writes a hidden temporary file in the folder of its target, or in the nearest folder
/// above it that exists, and reports every failure down to the disk (write, fsync, close); commit()
/// writes a journal and renames all staged files to their targets. The destructor removes files
/// that were staged and not committed; a commit that fails half way restores the state before it. A
/// folder that does not exist is filled under a hidden name and renamed as a whole; in a folder
/// that exists at the commit, files are replaced one by one and all other files stay. Several
/// threads may stage files and read them back at the same time.
///
/// Sets that change names in one folder are committed one after the other, so that the files on the
/// disk are those of one set. recover_unfinished() completes, takes back or removes the files of a
/// run that was killed. Until the process ends, the set keeps a lock in every folder that holds
/// temporary files of it, so that no other run takes it for a dead one.
///
/// Example usage:
///     require_writable("tile.obj", false);
///     OutputSet output;
///     output.stage("tile.obj", bytes);
///     if (!output.holds("tile.obj", bytes)) throw OutputError("tile.obj: the disk lost bytes");
///     output.wait_for_turn({});
///     output.commit(false);
class OutputSet {
   public:
    OutputSet() = default;
    ~OutputSet();
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;

    /// Declares that files staged later below `folder` belong to it.
    /// @throws OutputError with path and reason.
    void stage_folder(const std::string& folder);
    /// Writes `bytes` to the temporary file of `path`, piece by piece with checkpoints.
    /// @throws OutputError with path and reason; Cancelled.
    void stage(const std::string& path, const std::string& bytes);
    /// Returns whether the temporary file of `path`, which is staged, holds exactly these bytes.
    /// @throws OutputError if it cannot be read.
    bool holds(const std::string& path, std::string_view bytes) const;
    /// Stages files and reads them back, so that a proof of `files` is valid for the disk.
    /// @throws OutputError as stage(), and if the disk returns other bytes; Cancelled.
    void stage_and_compare(const std::vector<EncodedFile>& files);
    /// Waits until no other set is committed in the folders of the targets. From then on until this
    /// set is committed or destroyed, no other one is.
    /// @param waiting  may be empty.
    /// @returns the lines of recover_unfinished() for the sets of runs that died meanwhile.
    /// @throws Cancelled; OutputError with path and reason.
    std::vector<std::string> wait_for_turn(const WaitingCallback& waiting);
    /// Renames everything that is staged to its target, in turn with other sets.
    /// @throws OutputExists, OutputError with path and reason. No target is changed then, unless
    ///         the message says that recover_unfinished() has to complete the set or to take it
    ///         back.
    void commit(bool force);

   private:
    /// A journal, with the target of each move as the caller named it.
    struct Plan {
        Journal journal;
        std::vector<std::string> targets;
    };
    Plan plan(bool force) const;
    void add_move(FileMove::Kind kind, std::size_t run_file, const std::string& temporary,
                  const std::string& target, Plan& plan) const;
    FileMoves moves_of(const Plan& plan) const;
    void sync_staged(FileMoves& moves) const;
    void write_pointers();
    bool move_all(bool force, bool is_last_attempt);
    void take_back(FileMoves& moves, const FileMoves::Fault& fault);

    /// Guards the lists while files are staged.
    mutable std::mutex mutex_;
    CommitLocks locks_;
    bool has_turn_ = false;
    /// The run file of the first folder gets the journal.
    Staging staging_;
    /// The journal is on the disk, and recover_unfinished() has to deal with it.
    bool is_unfinished_ = false;
};

}  // namespace pcvt
