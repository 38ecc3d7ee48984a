#pragma once

#include <set>
#include <string>
#include <vector>

#include "io/outputs/run_file.hpp"

namespace pcvt {

/// The temporary files of a set, each on the file system of its target.
///
/// A file lies in the folder of its target under a hidden name. Where that folder is missing, the
/// outermost missing folder is made under a hidden name, with everything that belongs in it, so
/// that the commit can rename it as a whole. A run file accounts for the temporary files of each
/// folder.
///
/// Example usage:
///     Staging staging;
///     int file = staging.create("out/tile.obj");  // makes ".out.pcvt-TOKEN-0.new/tile.obj"
///     write_to_disk(file, bytes);
///     staging.follow(false);  // before the commit: "out" may exist by now
class Staging {
   public:
    struct File {
        std::string target;
        std::string temporary;
        /// The index of the run file in its folder; -1 in a folder that is renamed as a whole.
        int run_file = -1;
    };
    struct Folder {
        std::string target;
        std::string temporary;
        std::size_t run_file = 0;
        /// Every folder made for it, outer ones first.
        std::vector<std::string> created;
    };

    /// Declares a folder that must not exist before the commit, unless it exists now.
    /// @throws OutputError with path and reason.
    void add_folder(const std::string& path);
    /// Makes the temporary file of `path`. Returns its descriptor.
    /// @throws OutputError with path and reason.
    int create(const std::string& path);
    /// Returns the temporary file of `path`; empty if it has none.
    std::string temporary_of(const std::string& path) const;
    /// Returns the folders in which the commit would change names now.
    std::set<std::string> target_folders() const;
    /// Takes the files out of the folders that exist by now, so that each of them, and each folder
    /// that is still missing, is renamed by itself.
    /// @param force  whether files in declared folders may be replaced.
    /// @throws OutputError with path and reason.
    void follow(bool force);
    /// Removes all temporary files and run files.
    void remove() noexcept;
    /// Leaves the files and releases the run files, as the end of the process would.
    void abandon() noexcept;

    const std::vector<File>& files() const { return files_; }
    const std::vector<Folder>& folders() const { return folders_; }
    const std::vector<RunFile>& run_files() const { return run_files_; }
    std::vector<RunFile>& run_files() { return run_files_; }

   private:
    std::size_t run_file_for(const std::string& folder, const std::string& target);
    std::string temporary_path(const std::string& target, std::size_t run_file);
    Folder& missing_folder(const std::string& above, const std::string& leaf,
                           const std::string& target);
    void take_out(std::size_t folder);
    void take_out_file(File& file, std::size_t run_file);
    void take_out_folder(std::size_t folder, const std::string& target, const std::string& inner);

    std::vector<File> files_;
    std::vector<Folder> folders_;
    /// The folders that the caller declared and that did not exist.
    std::vector<std::string> declared_;
    std::vector<RunFile> run_files_;
    std::size_t n_temporaries_ = 0;
};

/// Returns the path of a target relative to an existing folder above it.
std::string path_below(const std::string& folder, const std::string& target);

}  // namespace pcvt
