#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/base/error.hpp"

namespace pcvt {

/// A file could not be written. The message names the path and the system's reason.
class OutputError : public Error {
   public:
    using Error::Error;
};

/// The file exists already and may not be replaced. The message ends there, because only the caller
/// knows how its users permit the replacement.
class OutputExists : public OutputError {
   public:
    using OutputError::OutputError;
};

/// Writes files, and folders of files, that appear together and complete, or not at all.
///
/// stage() writes a hidden temporary file in the folder of its target, or in the nearest folder
/// above it that exists, and reports every failure down to the disk (write, fsync, close); commit()
/// makes the missing folders and renames all staged files to their targets. The destructor removes
/// files that were staged and not committed; a commit that fails half way restores the state before
/// it. A folder that does not exist yet is filled under a hidden name and renamed as a whole; in an
/// existing folder, files are replaced one by one and all other files stay.
/// Several threads may stage files and read them back at the same time.
///
/// Example usage:
///     OutputSet::require_writable("tile.obj", false);
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

    /// Checks that `path` can be written; call it for every target before any computation.
    /// @param force  whether an existing target may be replaced.
    /// @throws OutputExists if the target exists and `force` is not set.
    /// @throws OutputError if the target is a folder, or if its folder is not writable, or is
    /// missing
    ///         and cannot be made.
    static void require_writable(const std::string& path, bool force);

    /// The same check for a folder and for `paths`, the files to be staged in it; `force` allows
    /// files in an existing folder to be replaced.
    static void require_writable_folder(const std::string& folder,
                                        const std::vector<std::string>& paths, bool force);

    /// Declares that files staged later below `folder` belong to it.
    /// @throws OutputError with path and reason.
    void stage_folder(const std::string& folder);
    /// Writes `bytes` to the temporary file of `path`.
    /// @throws OutputError with path and reason.
    void stage(const std::string& path, const std::string& bytes);
    /// Returns whether the temporary file of `path`, which is staged, holds exactly these bytes.
    bool holds(const std::string& path, std::string_view bytes) const;
    /// Renames everything that is staged to its target.
    /// @throws OutputExists, OutputError with path and reason; no target is changed then.
    void commit(bool force);

   private:
    struct Staged {
        std::string target;
        std::string temporary;
        /// During commit(): the second name of the file that it replaces.
        std::string backup;
        /// The file lies in a folder that is renamed as a whole.
        bool moves_with_folder = false;
    };
    struct Folder {
        std::string target;
        /// The name under which the folder is filled; empty if the target existed.
        std::string temporary;
        /// Every folder created for it, outer ones first.
        std::vector<std::string> created;
        bool moved = false;
    };
    int create(const std::string& path);
    void put_all(bool force, std::size_t& n_put);
    void take_back(std::size_t n_put);
    void remove_staged();
    static void put(Staged& file, bool force);

    /// Guards the two lists while files are staged.
    mutable std::mutex mutex_;
    std::vector<Staged> staged_;
    std::vector<Folder> folders_;
    /// The folders that commit() has made for targets, outer ones first.
    std::vector<std::string> made_;
};

}  // namespace pcvt
