#include "io/outputs/recovery.hpp"

#include <dirent.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <set>
#include <system_error>
#include <utility>

#include "io/bytes/output_error.hpp"
#include "io/outputs/commit_locks.hpp"
#include "io/outputs/journal.hpp"
#include "io/outputs/run_file.hpp"
#include "io/outputs/writable_paths.hpp"

namespace pcvt {
namespace {

namespace fs = std::filesystem;

/// The names in a folder that belong to runs.
struct RunNames {
    std::vector<std::string> tokens;
    /// Names of temporary files, each with its token.
    std::vector<std::pair<std::string, std::string>> temporaries;
    bool has_lock = false;
};

/// Reads a folder by the functions of POSIX, because the step of
/// std::filesystem::directory_iterator ends the process where memory is exhausted.
RunNames run_names(const std::string& folder) {
    RunNames names;
    const auto close = [](DIR* open) { ::closedir(open); };
    const std::unique_ptr<DIR, decltype(close)> open(::opendir(folder.c_str()), close);
    while (const dirent* entry = open ? ::readdir(open.get()) : nullptr) {
        const std::string leaf = entry->d_name;
        if (std::optional<std::string> token = run_file_token(leaf)) {
            names.tokens.push_back(*std::move(token));
        } else if ((token = temporary_token(leaf))) {
            names.temporaries.emplace_back(leaf, *std::move(token));
        } else if (is_commit_lock(leaf)) {
            names.has_lock = true;
        }
    }
    return names;
}

/// Returns the folders of the paths that exist, and the writable ones above them, each once.
std::set<std::string> folders_of(const std::vector<std::string>& paths) {
    std::set<std::string> folders;
    for (const std::string& path : paths) {
        fs::path at = fs::path(path);
        while (true) {
            // A path that names no folder lies in the current one.
            const fs::path above = at.has_parent_path() ? at.parent_path() : fs::path(".");
            if (above == at || !folders.insert(above.string()).second) break;
            if (!at.has_parent_path()) break;
            at = above;
        }
    }
    std::erase_if(folders, [](const std::string& folder) {
        return ::access(folder.c_str(), W_OK | X_OK) != 0;
    });
    return folders;
}

/// Removes the staged files and folders of a run; its backups stay.
void remove_temporaries(const std::string& folder, const std::string& token) {
    for (const auto& [leaf, owner] : run_names(folder).temporaries) {
        std::error_code ignored;
        if (owner == token) fs::remove_all(folder + "/" + leaf, ignored);
    }
}

/// Whether each folder between `folder` and the target is a folder, or is missing: so a
/// journal that somebody planted changes nothing behind a symbolic link.
bool has_plain_folders(const std::string& folder, const std::string& target) {
    for (std::size_t k = target.find('/'); k != std::string::npos; k = target.find('/', k + 1)) {
        NameStatus status;
        const std::string above = folder + "/" + target.substr(0, k);
        if (look_up(above.c_str(), status) != 0 || (status.exists && !status.is_folder))
            return false;
    }
    return true;
}

/// Returns the path without symbolic links, from the root on. The path may name a missing file,
/// whose relative name fs::weakly_canonical() would keep without fs::absolute().
std::string absolute_path(const std::string& path) {
    std::error_code unknown;
    const fs::path absolute = fs::absolute(path, unknown);
    if (unknown) return path;
    const fs::path canonical = fs::weakly_canonical(absolute, unknown);
    return unknown ? path : canonical.string();
}

[[noreturn]] void refuse(const std::string& folder, const FileMoves::Fault& fault) {
    throw OutputError(
        "folder " + folder +
        ": an earlier run ended while it wrote, and its files can be neither completed "
        "nor taken back: " +
        fault.path + ": " + reason_of(fault.error) + "; none is lost");
}

/// A set whose journal was found, with the folders in which it is unfinished.
class UnfinishedSet {
   public:
    /// @param master  the run file that holds the journal.
    UnfinishedSet(const RunFile& master, const Journal& journal) : journal_(journal) {
        for (const Journal::Folder& folder : journal.folders) {
            folders_.push_back(folder.path.empty() ? master.folder() : folder.path);
            is_agreed_.push_back(folder.path.empty() || points_to(folder, master));
        }
    }

    FileMoves moves() const {
        std::vector<FileMove> moves;
        for (const Journal::Move& move : journal_.moves) {
            const std::string& folder = folders_[move.folder];
            if (!is_agreed_[move.folder] || !has_plain_folders(folder, move.target)) continue;
            const std::string temporary = folder + "/" + move.temporary;
            const bool replaces = move.kind == FileMove::Kind::kReplacement;
            moves.push_back({.kind = move.kind,
                             .temporary = temporary,
                             .backup = replaces ? backup_path(temporary) : "",
                             .target = folder + "/" + move.target,
                             .fresh = move.fresh,
                             .old = move.old});
        }
        return {std::move(moves), agreed_folders()};
    }

    /// Removes all other names of the set; the run file of the journal goes last.
    void remove_run_files(RunFile& master) const {
        for (std::size_t f = 0; f < folders_.size(); ++f) {
            if (!is_agreed_[f]) continue;
            remove_temporaries(folders_[f], journal_.folders[f].token);
            const std::string path = folders_[f] + "/" + run_file_name(journal_.folders[f].token);
            if (path != master.path()) remove_name(path.c_str());
        }
        master.remove();
    }

   private:
    /// A folder that was finished has no run file any more; one that never belonged to the set, as
    /// a planted journal might state, has none that points to this journal.
    static bool points_to(const Journal::Folder& folder, const RunFile& master) {
        const std::optional<std::string> bytes = RunFile::content_of(folder.path, folder.token);
        if (!bytes) refuse(master.folder(), {EIO, folder.path.c_str()});
        const std::optional<std::string> target = decode_pointer(*bytes);
        return target && absolute_path(*target) == absolute_path(master.path());
    }
    std::set<std::string> agreed_folders() const {
        std::set<std::string> paths;
        for (std::size_t f = 0; f < folders_.size(); ++f) {
            if (is_agreed_[f]) paths.insert(folders_[f]);
        }
        return paths;
    }

    const Journal& journal_;
    std::vector<std::string> folders_;
    std::vector<bool> is_agreed_;
};

/// Completes the set of a journal, or takes it back. Returns a line that says so; nothing where
/// another set is being committed in one of the folders, which is left for the next run.
std::optional<std::string> finish_set(RunFile& master, const Journal& journal) {
    const UnfinishedSet set(master, journal);
    FileMoves moves = set.moves();
    std::set<std::string> targets;
    for (const FileMove& move : moves.moves()) targets.insert(existing_folder_of(move.target));
    CommitLocks locks;
    if (!locks.try_take(targets)) return {};
    const std::string line = master.folder() + ": an earlier run ended while it wrote; its " +
                             std::to_string(moves.moves().size()) + " files are ";
    if (moves.can_be_completed()) {
        const FileMoves::Fault fault = moves.put_all();
        if (fault.error == 0) {
            if (const FileMoves::Fault left = moves.remove_backups(); left.error != 0) {
                refuse(master.folder(), left);
            }
            set.remove_run_files(master);
            return line + "complete now";
        }
    }
    if (const FileMoves::Fault fault = moves.take_all_back(); fault.error != 0) {
        refuse(master.folder(), fault);
    }
    if (const int error = master.clear()) refuse(master.folder(), {error, master.path().c_str()});
    for (const FileMove& move : moves.moves()) remove_name(move.backup.c_str());
    set.remove_run_files(master);
    return line + "those of before again";
}

/// The state of a set, from a run file that no process owns.
struct Evidence {
    /// The run file with the journal; nothing if the run died before its commit.
    std::optional<RunFile> master;
    std::optional<Journal> journal;
    /// A living run, or another recovery, owns the journal.
    bool is_owned = false;
};

/// @param run  owned by this process; it is moved from where it is the master itself.
Evidence evidence_of(RunFile& run) {
    Evidence evidence;
    const std::optional<std::string> bytes = run.read();
    if (!bytes) {
        evidence.is_owned = true;
        return evidence;
    }
    if ((evidence.journal = decode_journal(*bytes))) {
        evidence.master.emplace(std::move(run));
        return evidence;
    }
    const std::optional<std::string> pointer = decode_pointer(*bytes);
    if (!pointer) return evidence;
    const fs::path path(*pointer);
    const std::optional<std::string> token = run_file_token(path.filename().string());
    if (!token) return evidence;
    RunFile master = RunFile::open(path.parent_path().string(), *token);
    if (master.owner() == RunFileOwner::kNobody) return evidence;
    const std::optional<std::string> content =
        master.owner() == RunFileOwner::kThisProcess ? master.read() : std::nullopt;
    evidence.is_owned = !content;
    if (content && (evidence.journal = decode_journal(*content))) {
        evidence.master.emplace(std::move(master));
    }
    return evidence;
}

/// Deals with one run file of a folder.
void recover(const std::string& folder, const std::string& token, std::vector<std::string>& lines) {
    RunFile run = RunFile::open(folder, token);
    if (run.owner() != RunFileOwner::kThisProcess) return;
    Evidence evidence = evidence_of(run);
    if (evidence.is_owned) return;
    if (!evidence.journal) {
        remove_temporaries(folder, token);
        run.remove();
        return;
    }
    run.release();
    std::optional<std::string> line = finish_set(*evidence.master, *evidence.journal);
    if (line) lines.push_back(*std::move(line));
}

/// Whether a folder that is moved as a whole contains one of the files, which are absolute paths.
bool contains_below(const std::string& temporary, const std::string& target,
                    const std::set<std::string>& files) {
    NameStatus waiting;
    if (look_up(temporary.c_str(), waiting) != 0) return true;
    const std::string below = target + "/";
    for (auto file = files.lower_bound(below); file != files.end() && file->starts_with(below);
         ++file) {
        NameStatus status;
        const std::string path = waiting.exists ? temporary + file->substr(target.size()) : *file;
        if (look_up(path.c_str(), status) != 0 || status.exists) return true;
    }
    return false;
}

/// Whether a set contains one of the files, which are absolute paths.
bool contains(const Journal& journal, const std::string& own_folder,
              const std::set<std::string>& files) {
    return std::any_of(journal.moves.begin(), journal.moves.end(), [&](const Journal::Move& move) {
        const std::string& named = journal.folders[move.folder].path;
        const std::string folder = (named.empty() ? own_folder : named) + "/";
        const std::string target = absolute_path(folder + move.target);
        if (files.contains(target)) return true;
        return move.kind == FileMove::Kind::kNewFolder &&
               contains_below(folder + move.temporary, target, files);
    });
}

}  // namespace

std::vector<std::string> recover_unfinished(const std::vector<std::string>& paths) {
    std::vector<std::string> lines;
    for (const std::string& folder : folders_of(paths)) {
        const RunNames names = run_names(folder);
        for (const std::string& token : names.tokens) recover(folder, token, lines);
        for (const auto& [leaf, token] : names.temporaries) {
            NameStatus owner;
            const std::string run_file = folder + "/" + run_file_name(token);
            if (look_up(run_file.c_str(), owner) == 0 && !owner.exists) {
                remove_temporaries(folder, token);
            }
        }
        if (names.has_lock) remove_stale_lock(folder);
    }
    return lines;
}

std::optional<std::string> unfinished_set_of(const std::vector<std::string>& paths) {
    std::set<std::string> files;
    for (const std::string& path : paths) files.insert(absolute_path(path));
    for (const std::string& folder : folders_of(paths)) {
        for (const std::string& token : run_names(folder).tokens) {
            RunFile run = RunFile::open(folder, token);
            if (run.owner() != RunFileOwner::kThisProcess) continue;
            const Evidence evidence = evidence_of(run);
            if (!evidence.journal) continue;
            if (contains(*evidence.journal, evidence.master->folder(), files)) {
                return evidence.master->path();
            }
        }
    }
    return {};
}

}  // namespace pcvt
