#include "io/outputs/file_moves.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "io/outputs/writable_paths.hpp"

namespace pcvt {
namespace {

/// How often a move back is tried.
constexpr int kMoveAttempts = 4;

/// The state of the three names of a move.
struct MoveStatus {
    NameStatus temporary;
    NameStatus backup;
    NameStatus target;
};

int look_up_names(const FileMove& move, MoveStatus& status) {
    int error = look_up(move.temporary.c_str(), status.temporary);
    if (error == 0) error = look_up(move.target.c_str(), status.target);
    if (error == 0 && !move.backup.empty()) error = look_up(move.backup.c_str(), status.backup);
    return error;
}

/// Gives the file at `target` a second name.
int keep(const FileMove& move, const MoveStatus& status) {
    if (!status.target.exists || status.backup.exists) return 0;
    if (status.target.is_folder) return EISDIR;
    if (::link(move.target.c_str(), move.backup.c_str()) == 0) return 0;
    // Somebody has removed the file since it was looked up.
    if (errno == ENOENT) return 0;
    // Hard links are not supported, or not permitted to another user's file.
    return ::rename(move.target.c_str(), move.backup.c_str()) == 0 ? 0 : errno;
}

int replace(const FileMove& move, const MoveStatus& status) {
    if (const int error = keep(move, status)) return error;
    if (::rename(move.temporary.c_str(), move.target.c_str()) != 0) return errno;
    // rename() does nothing where both names belong to one file already.
    return remove_name(move.temporary.c_str());
}

int put(const FileMove& move) {
    MoveStatus status;
    if (const int error = look_up_names(move, status)) return error;
    if (!status.temporary.exists) return 0;
    switch (move.kind) {
        case FileMove::Kind::kNewFile:
            return move_file_to_free_name(move.temporary.c_str(), move.target.c_str());
        case FileMove::Kind::kNewFolder:
            return move_folder_to_free_name(move.temporary.c_str(), move.target.c_str());
        case FileMove::Kind::kReplacement:
            break;
    }
    return replace(move, status);
}

int restore(const FileMove& move, const MoveStatus& status) {
    if (!status.backup.exists) return 0;
    const NameStatus& target = status.target;
    const bool is_ours =
        !target.exists || target.stamp == move.fresh || target.is_same_file(status.backup);
    if (!is_ours) return 0;
    // The new file keeps a name, so that the set can still be completed if this fails half way.
    const bool moved = target.exists && !target.is_same_file(status.backup);
    if (moved && !status.temporary.exists &&
        ::link(move.target.c_str(), move.temporary.c_str()) != 0 &&
        ::rename(move.target.c_str(), move.temporary.c_str()) != 0) {
        return errno;
    }
    if (::rename(move.backup.c_str(), move.target.c_str()) != 0) return errno;
    // rename() does nothing where both names belong to one file.
    return remove_name(move.backup.c_str());
}

int take_back(const FileMove& move) {
    MoveStatus status;
    if (const int error = look_up_names(move, status)) return error;
    if (move.kind == FileMove::Kind::kReplacement) return restore(move, status);
    if (status.temporary.exists) {
        return status.target.is_same_file(status.temporary) ? remove_name(move.target.c_str()) : 0;
    }
    if (move.kind == FileMove::Kind::kNewFolder) {
        if (!status.target.is_folder || status.target.stamp != move.fresh) return 0;
        return move_folder_to_free_name(move.target.c_str(), move.temporary.c_str());
    }
    if (!status.target.exists || status.target.stamp != move.fresh) return 0;
    return move_file_to_free_name(move.target.c_str(), move.temporary.c_str());
}

bool can_be_put(const FileMove& move) {
    MoveStatus status;
    if (look_up_names(move, status) != 0) return false;
    if (!status.temporary.exists) return true;
    const NameStatus& target = status.target;
    const bool is_free = !target.exists || target.is_same_file(status.temporary);
    if (move.kind == FileMove::Kind::kNewFolder) return is_free;
    if (status.temporary.stamp != move.fresh) return false;
    if (move.kind == FileMove::Kind::kNewFile) return is_free;
    return is_free ? status.backup.exists : target.stamp == move.old;
}

}  // namespace

FileMoves::FileMoves(std::vector<FileMove> moves, std::set<std::string> staging)
    : moves_(std::move(moves)), folders_(std::move(staging)) {
    for (const FileMove& move : moves_) folders_.insert(folder_of(move.target));
}

bool FileMoves::can_be_completed() const noexcept {
    for (const FileMove& move : moves_) {
        if (!can_be_put(move)) return false;
    }
    return true;
}

FileMoves::Fault FileMoves::put_all() noexcept {
    for (const FileMove& move : moves_) {
        if (const int error = put(move)) return {error, move.target.c_str()};
    }
    return sync_folders();
}

FileMoves::Fault FileMoves::take_all_back() noexcept {
    Fault fault;
    for (int attempt = 0; attempt < kMoveAttempts; ++attempt) {
        fault = {};
        for (auto move = moves_.rbegin(); move != moves_.rend(); ++move) {
            if (const int error = take_back(*move)) fault = {error, move->target.c_str()};
        }
        if (fault.error == 0) break;
    }
    if (fault.error != 0) return fault;
    return sync_folders();
}

FileMoves::Fault FileMoves::remove_backups() noexcept {
    for (const FileMove& move : moves_) {
        if (move.backup.empty()) continue;
        if (const int error = remove_name(move.backup.c_str())) {
            return {error, move.backup.c_str()};
        }
    }
    return sync_folders();
}

FileMoves::Fault FileMoves::sync_folders() noexcept {
    for (const std::string& folder : folders_) {
        const int error = sync_folder(folder.c_str());
        // A target whose folder is missing cannot be moved, which is reported.
        if (error != 0 && error != ENOENT && error != ENOTDIR) return {error, folder.c_str()};
    }
    return {};
}

}  // namespace pcvt
