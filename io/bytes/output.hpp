#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/base/error.hpp"

namespace pcvt {

/// A file could not be written; the message holds the path and the system's reason.
class OutputError : public Error {
   public:
    using Error::Error;
};

/// It exists already, and may not be replaced. The message ends there: how to allow it depends on
/// the caller.
class OutputExists : public OutputError {
   public:
    using OutputError::OutputError;
};

/// Files, and folders of files, that appear together and complete, or not at all.
///
/// stage() writes a hidden temporary file in the folder of its target and checks every byte down to
/// the disk (fsync, close); commit() renames them all. Whatever is staged and not committed is
/// removed by the destructor; a commit that fails half way takes back the files it had put there.
/// A folder that does not exist yet is filled under a hidden name and renamed as a whole; in one
/// that exists, files are replaced one by one and all others stay.
/// Threads may stage and read back at the same time.
class OutputSet {
   public:
    OutputSet() = default;
    ~OutputSet();
    OutputSet(const OutputSet&) = delete;
    OutputSet& operator=(const OutputSet&) = delete;

    /// @param force  whether an existing target may be replaced.
    /// To be asked for every target before any computing.
    /// @throws OutputExists if the target exists, without force.
    /// @throws OutputError if it is a folder, or its folder is missing or not writable.
    static void require_writable(const std::string& path, bool force);

    /// The same for a folder and the files in it that are to be staged; `force` lets files in a
    /// folder that exists be replaced.
    static void require_writable_folder(const std::string& folder,
                                        const std::vector<std::string>& paths, bool force);

    /// Says that paths below `folder`, staged later, belong to it.
    /// @throws OutputError with path and reason.
    void stage_folder(const std::string& folder);
    /// @throws OutputError with path and reason.
    void stage(const std::string& path, const std::string& bytes);
    /// Whether the disk gives back exactly these bytes for `path`, which is staged.
    bool holds(const std::string& path, std::string_view bytes) const;
    /// @throws OutputExists, OutputError with path and reason; no target is left changed then.
    void commit(bool force);

   private:
    struct Staged {
        std::string target;
        std::string temporary;
        /// While commit() is under way: where the file that it replaces is kept.
        std::string backup;
        /// It stands in a folder that is renamed as a whole.
        bool moves_with_folder = false;
    };
    struct Folder {
        std::string target;
        /// Where it is filled; empty if the target existed.
        std::string temporary;
        /// Every folder that was created on the way, outer ones first.
        std::vector<std::string> created;
        bool moved = false;
    };
    int create(const std::string& path);
    void make_folders(Folder& folder, const std::string& innermost);
    void put_all(bool force, std::size_t& n_put);
    void take_back(std::size_t n_put);
    void remove_staged();
    static void put(Staged& file, bool force);

    /// Guards the two lists while files are staged.
    mutable std::mutex mutex_;
    std::vector<Staged> staged_;
    std::vector<Folder> folders_;
};

}  // namespace pcvt
