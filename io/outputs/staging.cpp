#include "io/outputs/staging.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <utility>

#include "io/bytes/output_error.hpp"
#include "io/outputs/file_calls.hpp"
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

/// Returns the path of a name in a folder.
std::string path_in(const std::string& folder, const std::string& leaf) {
    return folder == "." ? leaf : folder + "/" + leaf;
}

bool exists(const std::string& path) {
    struct stat status {};
    return ::lstat(path.c_str(), &status) == 0;
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

/// Whether a path is that of a folder or lies below it.
bool is_within(const std::string& path, const std::string& folder) {
    return path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
}

void rename_temporary(const std::string& from, const std::string& to, const std::string& target) {
    if (::rename(from.c_str(), to.c_str()) != 0) throw_unwritable(target, reason_of(errno));
}

}  // namespace

std::string path_below(const std::string& folder, const std::string& target) {
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

/// Returns the index of the run file in an existing folder above `target`.
std::size_t Staging::run_file_for(const std::string& folder, const std::string& target) {
    for (std::size_t k = 0; k < run_files_.size(); ++k) {
        if (run_files_[k].folder() == folder) return k;
    }
    // A run file that exists already must find its place, or it would be left behind.
    run_files_.reserve(run_files_.size() + 1);
    run_files_.push_back(RunFile::create(folder, target));
    return run_files_.size() - 1;
}

/// Returns a name on the file system of `target`, below no folder that is missing.
std::string Staging::temporary_path(const std::string& target, std::size_t run_file) {
    const RunFile& run = run_files_[run_file];
    const std::string name = fs::path(target).filename().string();
    return run.path_of(temporary_leaf(name, run.token(), n_temporaries_++));
}

/// Returns the entry of the missing folder `leaf` in an existing one above `target`.
Staging::Folder& Staging::missing_folder(const std::string& above, const std::string& leaf,
                                         const std::string& target) {
    const std::size_t run_file = run_file_for(above, target);
    const std::string path = path_in(above, leaf);
    for (Folder& folder : folders_) {
        if (folder.run_file == run_file && folder.target == path) return folder;
    }
    Folder entry{path, temporary_path(path, run_file), run_file, {}};
    entry.created.push_back(entry.temporary);
    folders_.push_back(std::move(entry));
    if (::mkdir(folders_.back().temporary.c_str(), 0777) != 0) {
        throw_unwritable(target, reason_of(errno));
    }
    return folders_.back();
}

void Staging::add_folder(const std::string& path) {
    if (exists(path)) return;
    declared_.push_back(path);
    const std::string target = plain_path(path);
    const std::string above = existing_folder_of(target);
    const std::string rest = path_below(above, target);
    const std::size_t leaf = std::min(rest.find('/'), rest.size());
    Folder& folder = missing_folder(above, rest.substr(0, leaf), path);
    make_folders(folder.temporary + rest.substr(leaf), folder.created);
}

int Staging::create(const std::string& path) {
    files_.push_back({plain_path(path), {}, -1});
    File& entry = files_.back();
    const std::string above = existing_folder_of(entry.target);
    const std::string rest = path_below(above, entry.target);
    if (const std::size_t leaf = rest.find('/'); leaf != std::string::npos) {
        Folder& folder = missing_folder(above, rest.substr(0, leaf), path);
        entry.temporary = folder.temporary + rest.substr(leaf);
        make_folders(folder_of(entry.temporary), folder.created);
    } else {
        const std::size_t run_file = run_file_for(above, path);
        entry.run_file = static_cast<int>(run_file);
        entry.temporary = temporary_path(entry.target, run_file);
    }
    int file = -1;
    if (const int error = create_file(entry.temporary.c_str(), file)) {
        throw_unwritable(path, reason_of(error));
    }
    return file;
}

std::string Staging::temporary_of(const std::string& path) const {
    const std::string target = plain_path(path);
    for (const File& file : files_) {
        if (file.target == path || file.target == target) return file.temporary;
    }
    return "";
}

std::set<std::string> Staging::target_folders() const {
    std::set<std::string> folders;
    for (const File& file : files_) folders.insert(existing_folder_of(file.target));
    return folders;
}

void Staging::take_out_file(File& file, std::size_t run_file) {
    std::string temporary = temporary_path(file.target, run_file);
    rename_temporary(file.temporary, temporary, file.target);
    file.temporary = std::move(temporary);
    file.run_file = static_cast<int>(run_file);
}

/// Makes a folder in another one an entry by itself.
/// @param inner  its temporary name.
void Staging::take_out_folder(std::size_t from, const std::string& target,
                              const std::string& inner) {
    const std::size_t run_file = folders_[from].run_file;
    const std::string fresh = temporary_path(target, run_file);
    // All memory is allocated before the rename, after which the entries must be right.
    folders_.push_back({target, fresh, run_file, {}});
    std::vector<std::pair<std::string*, std::string>> renamed;
    const auto note = [&](std::string& path) {
        if (is_within(path, inner)) renamed.emplace_back(&path, fresh + path.substr(inner.size()));
    };
    for (File& file : files_) note(file.temporary);
    std::vector<std::string>& created = folders_[from].created;
    for (std::string& path : created) note(path);
    folders_.back().created.reserve(created.size());

    rename_temporary(inner, fresh, target);
    for (auto& [path, name] : renamed) path->swap(name);
    const auto moved = std::stable_partition(
        created.begin(), created.end(), [&](const auto& path) { return !is_within(path, fresh); });
    std::move(moved, created.end(), std::back_inserter(folders_.back().created));
    created.erase(moved, created.end());
}

/// Takes everything out of the temporary folder of an entry, and removes the entry.
void Staging::take_out(std::size_t folder) {
    for (File& file : files_) {
        if (!is_within(file.temporary, folders_[folder].temporary)) continue;
        const std::string above = existing_folder_of(file.target);
        const std::string rest = path_below(above, file.target);
        const std::size_t leaf = rest.find('/');
        if (leaf == std::string::npos) {
            take_out_file(file, folders_[folder].run_file);
        } else {
            const std::size_t n_inner = file.temporary.size() - (rest.size() - leaf);
            take_out_folder(folder, path_in(above, rest.substr(0, leaf)),
                            file.temporary.substr(0, n_inner));
        }
    }
    remove_folders(folders_[folder].created);
    folders_.erase(folders_.begin() + static_cast<std::ptrdiff_t>(folder));
}

void Staging::follow(bool force) {
    for (const std::string& folder : declared_) {
        if (!force && exists(folder)) refuse_existing(folder);
    }
    for (std::size_t k = 0; k < folders_.size();) {
        if (exists(folders_[k].target)) {
            take_out(k);
        } else {
            ++k;
        }
    }
}

void Staging::remove() noexcept {
    for (const File& file : files_) remove_name(file.temporary.c_str());
    for (const Folder& folder : folders_) remove_folders(folder.created);
    // The journal goes last: it accounts for all other names.
    for (auto run = run_files_.rbegin(); run != run_files_.rend(); ++run) run->remove();
    abandon();
}

void Staging::abandon() noexcept {
    files_.clear();
    folders_.clear();
    run_files_.clear();
}

}  // namespace pcvt
