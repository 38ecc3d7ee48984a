#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "io/outputs/file_moves.hpp"
#include "io/outputs/journal.hpp"
#include "io/outputs/run_file.hpp"

namespace pcvt {

/// Writes files, and folders of files, that appear together and complete, or not at all.
///
/// stage() writes a hidden temporary file in the folder of its target, or in the nearest folder
/// above it that exists, and reports every failure down to the disk (write, fsync, close); commit()
/// writes a journal, makes the missing folders and renames all staged files to their targets. The
/// destructor removes files that were staged and not committed; a commit that fails half way
/// restores the state before it. A folder that does not exist yet is filled under a hidden name and
/// renamed as a whole; in an existing folder, files are replaced one by one and all other files
/// stay. Several threads may stage files and read them back at the same time.
///
/// recover_unfinished() completes, takes back or removes the files of a run that was killed. Until
/// the process ends, the set keeps a lock in every folder that holds temporary files of it, so that
/// no other run takes it for a dead one.
///
/// Example usage:
///     require_writable("tile.obj", false);
///     OutputSet output;
///     output.stage("tile.obj", bytes);
///     if (!output.holds("tile.obj", bytes)) throw OutputError("tile.obj: the disk lost bytes");
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
    /// Renames everything that is staged to its target.
    /// @throws OutputExists, OutputError with path and reason. No target is changed then, unless
    /// the
    ///         message says that recover_unfinished() has to complete the set or to take it back.
    void commit(bool force);

   private:
    struct Staged {
        std::string target;
        std::string temporary;
        /// The index of the folder that it lies in; -1 in a folder that is renamed as a whole.
        int run_file = -1;
    };
    struct Folder {
        std::string target;
        /// The name under which the folder is filled; empty if the target existed.
        std::string temporary;
        int run_file = -1;
        /// Every folder created for it, outer ones first.
        std::vector<std::string> created;
    };
    /// A journal, with the target of each move as the caller named it.
    struct Plan {
        Journal journal;
        std::vector<std::string> targets;
    };
    int create(const std::string& path);
    std::size_t run_file_for(const std::string& target);
    std::string temporary_path(const std::string& target, std::size_t run_file);
    Plan plan(bool force) const;
    void add_move(FileMove::Kind kind, std::size_t run_file, const std::string& temporary,
                  const std::string& target, Plan& plan) const;
    void add_missing_folders(const std::string& target, std::size_t run_file,
                             Journal& journal) const;
    FileMoves moves_of(const Plan& plan) const;
    void sync_staged(FileMoves& moves) const;
    void write_pointers();
    [[noreturn]] void take_back(FileMoves& moves, const FileMoves::Fault& fault, const Plan& plan);
    void clear() noexcept;

    /// Guards the lists while files are staged.
    mutable std::mutex mutex_;
    std::vector<Staged> staged_;
    std::vector<Folder> folders_;
    /// One for each folder that holds temporary files; the first one gets the journal.
    std::vector<RunFile> run_files_;
    std::size_t n_temporaries_ = 0;
    /// The journal is on the disk, and recover_unfinished() has to deal with it.
    bool is_unfinished_ = false;
};

}  // namespace pcvt
