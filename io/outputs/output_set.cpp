#include "io/outputs/output_set.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>
#include <utility>

#include "io/bytes/input_file.hpp"
#include "io/bytes/output_error.hpp"
#include "io/outputs/disk_write.hpp"
#include "io/outputs/recovery.hpp"
#include "io/outputs/writable_paths.hpp"

namespace pcvt {
namespace {

namespace fs = std::filesystem;

/// How often the moves of a commit are chosen, where names appear between the choice and the move.
/// Only a file system without locks, or another program, makes this happen.
constexpr int kAttempts = 20;

std::string absolute_folder(const std::string& folder) {
    std::error_code error;
    const fs::path path = fs::canonical(folder, error);
    return error ? folder : path.string();
}

NameStatus status_of(const std::string& path) {
    NameStatus status;
    if (const int error = look_up(path.c_str(), status)) throw_unwritable(path, reason_of(error));
    return status;
}

}  // namespace

OutputSet::~OutputSet() {
    if (!is_unfinished_) staging_.remove();
}

void OutputSet::stage_folder(const std::string& path) {
    const std::lock_guard lock(mutex_);
    staging_.add_folder(path);
}

void OutputSet::stage(const std::string& path, const std::string& bytes) {
    int file = -1;
    {
        const std::lock_guard lock(mutex_);
        file = staging_.create(path);
    }
    if (const int error = write_to_disk(file, bytes)) throw_unwritable(path, reason_of(error));
}

bool OutputSet::holds(const std::string& path, std::string_view bytes) const {
    std::string temporary;
    {
        const std::lock_guard lock(mutex_);
        temporary = staging_.temporary_of(path);
    }
    if (temporary.empty()) throw InternalError(path + " was read back before it was staged");
    try {
        return file_holds(temporary, bytes);
    } catch (const BadFile& error) {
        throw OutputError(path + ": cannot be read back: " + error.what());
    }
}

void OutputSet::stage_and_compare(const std::vector<EncodedFile>& files) {
    for (const EncodedFile& file : files) stage(file.path, file.bytes);
    for (const EncodedFile& file : files) {
        if (holds(file.path, file.bytes)) continue;
        throw OutputError(file.path + ": the disk gives back other bytes than were written");
    }
}

void OutputSet::add_move(FileMove::Kind kind, std::size_t run_file, const std::string& temporary,
                         const std::string& target, Plan& plan) const {
    const NameStatus fresh = status_of(temporary);
    const NameStatus old = status_of(target);
    if (kind == FileMove::Kind::kReplacement) {
        if (old.is_folder) throw_unwritable(target, reason_of(EISDIR));
        if (!old.exists) kind = FileMove::Kind::kNewFile;
    } else if (kind == FileMove::Kind::kNewFile && old.exists) {
        refuse_existing(target);
    }
    plan.journal.moves.push_back(
        {.kind = kind,
         .folder = run_file,
         .temporary = fs::path(temporary).filename().string(),
         .target = path_below(staging_.run_files()[run_file].folder(), target),
         .fresh = fresh.stamp,
         .old = old.stamp});
    plan.targets.push_back(target);
}

OutputSet::Plan OutputSet::plan(bool force) const {
    Plan plan;
    for (const RunFile& run : staging_.run_files()) {
        const bool is_first = plan.journal.folders.empty();
        plan.journal.folders.push_back(
            {is_first ? "" : absolute_folder(run.folder()), run.token()});
    }
    const FileMove::Kind kind = force ? FileMove::Kind::kReplacement : FileMove::Kind::kNewFile;
    for (const Staging::File& file : staging_.files()) {
        if (file.run_file < 0) continue;
        add_move(kind, static_cast<std::size_t>(file.run_file), file.temporary, file.target, plan);
    }
    for (const Staging::Folder& folder : staging_.folders()) {
        add_move(FileMove::Kind::kNewFolder, folder.run_file, folder.temporary, folder.target,
                 plan);
    }
    return plan;
}

FileMoves OutputSet::moves_of(const Plan& plan) const {
    std::vector<FileMove> moves;
    for (std::size_t k = 0; k < plan.targets.size(); ++k) {
        const Journal::Move& move = plan.journal.moves[k];
        const std::string temporary = staging_.run_files()[move.folder].path_of(move.temporary);
        const bool replaces = move.kind == FileMove::Kind::kReplacement;
        moves.push_back({.kind = move.kind,
                         .temporary = temporary,
                         .backup = replaces ? backup_path(temporary) : "",
                         .target = plan.targets[k],
                         .fresh = move.fresh,
                         .old = move.old});
    }
    std::set<std::string> folders;
    for (const RunFile& run : staging_.run_files()) folders.insert(run.folder());
    return {std::move(moves), std::move(folders)};
}

/// Waits until the names of all temporary files are on the disk; their contents are.
void OutputSet::sync_staged(FileMoves& moves) const {
    FileMoves::Fault fault = moves.sync_folders();
    for (const Staging::Folder& folder : staging_.folders()) {
        for (const std::string& path : folder.created) {
            if (fault.error == 0) fault = {sync_folder(path.c_str()), path.c_str()};
        }
    }
    if (fault.error != 0) throw_unwritable(fault.path, reason_of(fault.error));
}

/// Makes every run file but the first one point to that one.
void OutputSet::write_pointers() {
    std::vector<RunFile>& run_files = staging_.run_files();
    const std::string pointer = encode_pointer(absolute_folder(run_files[0].folder()) + "/" +
                                               run_file_name(run_files[0].token()));
    for (std::size_t k = 1; k < run_files.size(); ++k) {
        if (const int error = run_files[k].write(pointer)) {
            throw_unwritable(run_files[k].path(), reason_of(error));
        }
    }
}

/// Undoes the moves, of which one failed.
void OutputSet::take_back(FileMoves& moves, const FileMoves::Fault& fault) {
    const FileMoves::Fault left = moves.take_all_back();
    is_unfinished_ = left.error != 0 || staging_.run_files()[0].clear() != 0;
    if (!is_unfinished_) return;
    throw_unwritable(fault.path,
                     reason_of(fault.error) +
                         "; the files before this run cannot be restored either. No file is "
                         "lost: the next run that writes to this folder completes the files "
                         "of this run or restores those before it");
}

std::vector<std::string> OutputSet::wait_for_turn(const WaitingCallback& waiting) {
    std::vector<std::string> targets;
    for (const Staging::File& file : staging_.files()) targets.push_back(file.target);
    std::vector<std::string> recovered;
    while (!has_turn_) {
        locks_.take(staging_.target_folders(), waiting);
        // The set before this one may have changed the folders, or may have died in its commit.
        const bool is_unfinished = unfinished_set_of(targets).has_value();
        has_turn_ = !is_unfinished && locks_.are_of(staging_.target_folders());
        if (!is_unfinished) continue;
        locks_.release();
        for (std::string& line : recover_unfinished(targets)) recovered.push_back(std::move(line));
    }
    return recovered;
}

/// Makes one attempt to move everything. Returns false if the moves have to be chosen again,
/// because a name that was free is taken by now.
///
/// The order of the steps keeps the set whole if the power fails between any two of them:
///   1. the contents of the temporary files are on the disk (stage), then their names,
///   2. the pointers, then the journal: from its last byte on, the new files will replace the old,
///   3. the new names of the files, before any old file loses its last name,
///   4. the removal of the old files, before that of the journal, which accounts for them.
/// From step 2 on nothing allocates, so that no lack of memory ends the commit half way.
bool OutputSet::move_all(bool force, bool is_last_attempt) {
    staging_.follow(force);
    const Plan plan = this->plan(force);
    FileMoves moves = moves_of(plan);
    const std::string journal = encode_journal(plan.journal);
    sync_staged(moves);
    write_pointers();

    RunFile& master = staging_.run_files()[0];
    FileMoves::Fault fault{master.write(journal), master.path().c_str()};
    if (fault.error == 0) fault = moves.put_all();
    if (fault.error != 0) {
        take_back(moves, fault);
        if (fault.error != EEXIST) throw_unwritable(fault.path, reason_of(fault.error));
        if (is_last_attempt) refuse_existing(fault.path);
        return false;
    }
    // All files are new. If an old one cannot be removed, the journal stays for the next run.
    is_unfinished_ = moves.remove_backups().error != 0;
    return true;
}

void OutputSet::commit(bool force) {
    if (staging_.run_files().empty()) return;
    wait_for_turn({});
    int attempts_left = kAttempts;
    do {
        --attempts_left;
    } while (!move_all(force, attempts_left == 0));
    if (is_unfinished_) {
        staging_.abandon();
    } else {
        staging_.remove();
    }
    locks_.release();
    has_turn_ = false;
}

}  // namespace pcvt
