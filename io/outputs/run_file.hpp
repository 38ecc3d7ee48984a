#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pcvt {

/// The names of a run in a folder: the run file `.pcvt-TOKEN`, which the living run keeps locked
/// and which becomes the journal of the commit, and the temporary files `.NAME.pcvt-TOKEN-K.new`
/// and
/// `.NAME.pcvt-TOKEN-K.old`.
std::string run_file_name(std::string_view token);
std::string temporary_leaf(const std::string& name, std::string_view token, std::size_t k);
/// Returns the token of a run file, or of a temporary `.new`; nothing for other names.
std::optional<std::string> run_file_token(std::string_view leaf);
std::optional<std::string> temporary_token(std::string_view leaf);
/// The name of the backup that belongs to a temporary name.
std::string backup_path(const std::string& temporary);

/// The result of an attempt to own a run file.
enum class RunFileOwner { kNobody, kLivingRun, kThisProcess };

/// The open, locked run file of a folder. The system releases the lock when the process ends, in
/// any way; a lock in the same process excludes other sets too.
///
/// Example usage:
///     RunFile file = RunFile::create("out", "out/tile.obj");  // locked from here on
///     file.write(journal);
///     file.remove();
class RunFile {
   public:
    /// Makes the run file of a new token in `folder`.
    /// @param target  the file for whose sake, for the message.
    /// @throws OutputError with target and reason.
    static RunFile create(const std::string& folder, const std::string& target);
    /// Opens a run file that was found, and locks it unless a living run owns it. Files of another
    /// user, and files that cannot be locked, count as those of a living run.
    static RunFile open(const std::string& folder, const std::string& token);

    /// Returns the content of a run file without locking it; empty where there is none, or one of
    /// another user. Returns nothing if it cannot be read.
    static std::optional<std::string> content_of(const std::string& folder,
                                                 const std::string& token);

    RunFile(RunFile&& other) noexcept;
    RunFile& operator=(RunFile&&) = delete;
    ~RunFile();

    RunFileOwner owner() const { return owner_; }
    const std::string& folder() const { return folder_; }
    const std::string& token() const { return token_; }
    const std::string& path() const { return path_; }
    std::string path_of(const std::string& leaf) const { return folder_ + "/" + leaf; }

    /// Returns the content, or nothing if it cannot be read.
    std::optional<std::string> read() const;
    /// Replaces the content, and waits until it is on the disk. Returns 0, or the system's error.
    int write(std::string_view bytes) noexcept;
    /// Makes the content empty in one of several ways. Returns 0, or the system's error.
    int clear() noexcept;
    /// Removes the file, which releases the lock.
    void remove() noexcept;
    /// Releases the lock and leaves the file, as the end of the process would.
    void release() noexcept;

   private:
    RunFile(std::string folder, std::string token);

    std::string folder_;
    std::string token_;
    std::string path_;
    int file_ = -1;
    RunFileOwner owner_ = RunFileOwner::kNobody;
};

}  // namespace pcvt
