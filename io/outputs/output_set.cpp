#include "io/outputs/output_set.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <utility>

#include "io/bytes/input_file.hpp"
#include "io/bytes/output_error.hpp"
#include "io/outputs/disk_write.hpp"
#include "io/outputs/writable_paths.hpp"

namespace pcvt {
namespace {

namespace fs = std::filesystem;

/// Returns the path without steps upwards in folders that are missing yet, which a journal does not
/// store.
std::string plain_path(const std::string& path) {
    const fs::path steps(path);
    if (std::find(steps.begin(), steps.end(), fs::path("..")) == steps.end()) return path;
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(steps.parent_path(), error);
    return error ? path : (canonical / steps.filename()).string();
}

/// Returns the path of a target relative to an existing folder above it.
std::string below(const std::string& folder, const std::string& target) {
    std::string rest;
    fs::path at(target);
    while (true) {
        const std::string leaf = at.filename().string();
        if (!leaf.empty() && leaf != ".") rest = leaf + (rest.empty() ? "" : "/") + rest;
        const std::string above = folder_of(at.string());
        if (above == folder || above == at.string()) return rest;
        at = above;
    }
}

std::string absolute_folder(const std::string& folder) {
    std::error_code error;
    const fs::path path = fs::canonical(folder, error);
    return error ? folder : path.string();
}

/// Creates `innermost` with all missing folders above it, and appends them to `created`.
void make_folders(const std::string& innermost, std::vector<std::string>& created) {
    struct stat status {};
    if (::stat(innermost.c_str(), &status) == 0) return;
    if (const std::string above = folder_of(innermost); above != innermost) {
        make_folders(above, created);
    }
    // Listed first, because a folder without an entry would be left behind if memory ran out.
    created.push_back(innermost);
    if (::mkdir(innermost.c_str(), 0777) == 0) return;
    const int error = errno;
    created.pop_back();
    if (error != EEXIST) {
        throw OutputError(innermost + ": cannot make the folder: " + reason_of(error));
    }
}

/// Removes folders in the reverse order. Keeps folders into which somebody else has put a file.
void remove_folders(const std::vector<std::string>& created) noexcept {
    for (auto path = created.rbegin(); path != created.rend(); ++path) ::rmdir(path->c_str());
}

NameStatus status_of(const std::string& path) {
    NameStatus status;
    if (const int error = look_up(path.c_str(), status)) throw_unwritable(path, reason_of(error));
    return status;
}

}  // namespace

OutputSet::~OutputSet() {
    if (!is_unfinished_) clear();
}

/// Removes all temporary files and run files of the set.
void OutputSet::clear() noexcept {
    for (const Staged& file : staged_) remove_name(file.temporary.c_str());
    for (const Folder& folder : folders_) remove_folders(folder.created);
    // The journal goes last: it accounts for all other names.
    for (auto run = run_files_.rbegin(); run != run_files_.rend(); ++run) run->remove();
    staged_.clear();
    folders_.clear();
    run_files_.clear();
}

/// Returns the index of the run file in the nearest existing folder above `target`.
std::size_t OutputSet::run_file_for(const std::string& target) {
    const std::string folder = existing_folder_of(target);
    for (std::size_t k = 0; k < run_files_.size(); ++k) {
        if (run_files_[k].folder() == folder) return k;
    }
    // A run file that exists already must find its place, or it would be left behind.
    run_files_.reserve(run_files_.size() + 1);
    run_files_.push_back(RunFile::create(folder, target));
    return run_files_.size() - 1;
}

/// Returns a name on the file system of `target`, below no folder that is missing.
std::string OutputSet::temporary_path(const std::string& target, std::size_t run_file) {
    const RunFile& run = run_files_[run_file];
    const std::string name = fs::path(target).filename().string();
    return run.path_of(temporary_leaf(name, run.token(), n_temporaries_++));
}

void OutputSet::stage_folder(const std::string& path) {
    const std::lock_guard lock(mutex_);
    Folder entry{path, {}, -1, {}};
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0) {
        const std::size_t run_file = run_file_for(path);
        entry.run_file = static_cast<int>(run_file);
        entry.temporary = temporary_path(path, run_file);
        entry.created.push_back(entry.temporary);
    }
    folders_.push_back(std::move(entry));
    const std::string& temporary = folders_.back().temporary;
    if (!temporary.empty() && ::mkdir(temporary.c_str(), 0777) != 0) {
        throw_unwritable(path, reason_of(errno));
    }
}

/// Creates and opens the temporary file that replaces `path` in commit().
int OutputSet::create(const std::string& path) {
    const std::lock_guard lock(mutex_);
    Staged entry{path, {}, -1};
    for (Folder& folder : folders_) {
        if (folder.temporary.empty() || !path.starts_with(folder.target + "/")) continue;
        entry.temporary = folder.temporary + path.substr(folder.target.size());
        make_folders(folder_of(entry.temporary), folder.created);
    }
    if (entry.temporary.empty()) {
        entry.target = plain_path(path);
        const std::size_t run_file = run_file_for(entry.target);
        entry.run_file = static_cast<int>(run_file);
        entry.temporary = temporary_path(entry.target, run_file);
    }
    staged_.push_back(std::move(entry));
    int file = -1;
    if (const int error = create_file(staged_.back().temporary.c_str(), file)) {
        throw_unwritable(path, reason_of(error));
    }
    return file;
}

void OutputSet::stage(const std::string& path, const std::string& bytes) {
    const int error = write_to_disk(create(path), bytes);
    if (error != 0) throw_unwritable(path, reason_of(error));
}

bool OutputSet::holds(const std::string& path, std::string_view bytes) const {
    std::string temporary;
    {
        const std::lock_guard lock(mutex_);
        const std::string target = plain_path(path);
        for (const Staged& file : staged_) {
            if (file.target == path || file.target == target) temporary = file.temporary;
        }
    }
    if (temporary.empty()) throw InternalError(path + " was read back before it was staged");
    try {
        return file_holds(temporary, bytes);
    } catch (const BadFile& error) {
        throw OutputError(path + ": cannot be read back: " + error.what());
    }
}

/// Lists the folders that are missing between a folder and a target in it.
void OutputSet::add_missing_folders(const std::string& target, std::size_t run_file,
                                    Journal& journal) const {
    for (std::size_t k = target.find('/'); k != std::string::npos; k = target.find('/', k + 1)) {
        const std::string folder = target.substr(0, k);
        const auto is_listed = [&](const Journal::MissingFolder& missing) {
            return missing.folder == run_file && missing.path == folder;
        };
        struct stat status {};
        if (::stat(run_files_[run_file].path_of(folder).c_str(), &status) == 0) continue;
        if (std::any_of(journal.missing.begin(), journal.missing.end(), is_listed)) continue;
        journal.missing.push_back({run_file, folder});
    }
}

void OutputSet::add_move(FileMove::Kind kind, std::size_t run_file, const std::string& temporary,
                         const std::string& target, Plan& plan) const {
    const NameStatus fresh = status_of(temporary);
    const NameStatus old = status_of(target);
    if (kind == FileMove::Kind::kReplacement) {
        if (old.is_folder) throw_unwritable(target, reason_of(EISDIR));
        if (!old.exists) kind = FileMove::Kind::kNewFile;
    }
    const std::string path = below(run_files_[run_file].folder(), target);
    plan.journal.moves.push_back({.kind = kind,
                                  .folder = run_file,
                                  .temporary = fs::path(temporary).filename().string(),
                                  .target = path,
                                  .fresh = fresh.stamp,
                                  .old = old.stamp});
    plan.targets.push_back(target);
    add_missing_folders(path, run_file, plan.journal);
}

OutputSet::Plan OutputSet::plan(bool force) const {
    Plan plan;
    for (std::size_t k = 0; k < run_files_.size(); ++k) {
        const std::string path = k == 0 ? "" : absolute_folder(run_files_[k].folder());
        plan.journal.folders.push_back({path, run_files_[k].token()});
    }
    const FileMove::Kind kind = force ? FileMove::Kind::kReplacement : FileMove::Kind::kNewFile;
    for (const Staged& file : staged_) {
        if (file.run_file < 0) continue;
        add_move(kind, static_cast<std::size_t>(file.run_file), file.temporary, file.target, plan);
    }
    for (const Folder& folder : folders_) {
        if (folder.run_file < 0) continue;
        add_move(FileMove::Kind::kNewFolder, static_cast<std::size_t>(folder.run_file),
                 folder.temporary, folder.target, plan);
    }
    return plan;
}

FileMoves OutputSet::moves_of(const Plan& plan) const {
    std::vector<FileMove> moves;
    for (std::size_t k = 0; k < plan.targets.size(); ++k) {
        const Journal::Move& move = plan.journal.moves[k];
        const std::string temporary = run_files_[move.folder].path_of(move.temporary);
        const bool replaces = move.kind == FileMove::Kind::kReplacement;
        moves.push_back({.kind = move.kind,
                         .temporary = temporary,
                         .backup = replaces ? backup_path(temporary) : "",
                         .target = plan.targets[k],
                         .fresh = move.fresh,
                         .old = move.old});
    }
    std::vector<std::string> missing;
    for (const Journal::MissingFolder& folder : plan.journal.missing) {
        missing.push_back(run_files_[folder.folder].path_of(folder.path));
    }
    std::vector<std::string> staging;
    for (const RunFile& run : run_files_) staging.push_back(run.folder());
    return {std::move(moves), std::move(missing), std::move(staging)};
}

/// Waits until the names of all temporary files are on the disk; their contents are.
void OutputSet::sync_staged(FileMoves& moves) const {
    FileMoves::Fault fault = moves.sync_folders();
    for (const Folder& folder : folders_) {
        for (const std::string& path : folder.created) {
            if (fault.error == 0) fault = {sync_folder(path.c_str()), path.c_str()};
        }
    }
    if (fault.error != 0) throw_unwritable(fault.path, reason_of(fault.error));
}

/// Makes every run file but the first one point to that one.
void OutputSet::write_pointers() {
    const std::string pointer = encode_pointer(absolute_folder(run_files_[0].folder()) + "/" +
                                               run_file_name(run_files_[0].token()));
    for (std::size_t k = 1; k < run_files_.size(); ++k) {
        if (const int error = run_files_[k].write(pointer)) {
            throw_unwritable(run_files_[k].path(), reason_of(error));
        }
    }
}

/// Undoes a commit that failed, and reports `fault`.
void OutputSet::take_back(FileMoves& moves, const FileMoves::Fault& fault, const Plan& plan) {
    const FileMoves::Fault left = moves.take_all_back();
    is_unfinished_ = left.error != 0 || run_files_[0].clear() != 0;
    if (is_unfinished_) {
        throw_unwritable(fault.path,
                         reason_of(fault.error) +
                             "; the files before this run cannot be restored either. No file is "
                             "lost: the next run that writes to this folder completes the files "
                             "of this run or restores those before it");
    }
    if (fault.error != EEXIST) throw_unwritable(fault.path, reason_of(fault.error));
    for (std::size_t k = 0; k < plan.targets.size(); ++k) {
        if (plan.targets[k] != fault.path) continue;
        if (plan.journal.moves[k].kind != FileMove::Kind::kNewFolder) break;
        throw_unwritable(fault.path, "it exists; use --force to replace it");
    }
    refuse_existing(fault.path);
}

/// The order of the steps keeps the set whole if the power fails between any two of them:
///   1. the contents of the temporary files are on the disk (stage), then their names,
///   2. the pointers, then the journal: from its last byte on, the new files will replace the old,
///   3. the new names of the files, before any old file loses its last name,
///   4. the removal of the old files, before that of the journal, which accounts for them.
/// From step 2 on nothing allocates, so that no lack of memory ends the commit half way.
void OutputSet::commit(bool force) {
    if (run_files_.empty()) return;
    const Plan plan = this->plan(force);
    FileMoves moves = moves_of(plan);
    const std::string journal = encode_journal(plan.journal);
    sync_staged(moves);
    write_pointers();

    FileMoves::Fault fault{run_files_[0].write(journal), run_files_[0].path().c_str()};
    if (fault.error == 0) fault = moves.put_all();
    if (fault.error != 0) take_back(moves, fault, plan);
    // All files are new. If an old one cannot be removed, the journal stays for the next run.
    is_unfinished_ = moves.remove_backups().error != 0;
    staged_.clear();
    folders_.clear();
    if (is_unfinished_) {
        run_files_.clear();
    } else {
        clear();
    }
}

}  // namespace pcvt
