#include "io/outputs/writable_paths.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "io/bytes/output_error.hpp"
#include "io/outputs/file_calls.hpp"

namespace pcvt {

std::string folder_of(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

std::string existing_folder_of(const std::string& path) {
    std::string folder = folder_of(path);
    struct stat status {};
    while (folder != "." && ::lstat(folder.c_str(), &status) != 0 &&
           (errno == ENOENT || errno == ENOTDIR)) {
        folder = folder_of(folder);
    }
    return folder;
}

void throw_unwritable(const std::string& path, const std::string& reason) {
    throw OutputError(path + ": cannot write: " + reason);
}

void refuse_existing(const std::string& path) {
    throw OutputExists(path + ": cannot write: it exists");
}

void require_writable(const std::string& path, bool force) {
    struct stat status {};
    if (path.empty() || path.back() == '/') throw_unwritable(path, "the path has no file name");
    if (::lstat(path.c_str(), &status) == 0) {
        if (::stat(path.c_str(), &status) == 0) {
            if (S_ISDIR(status.st_mode)) throw_unwritable(path, reason_of(EISDIR));
            if (!S_ISREG(status.st_mode)) throw_unwritable(path, "it is not a regular file");
        }
        if (!force) refuse_existing(path);
    }
    const std::string folder = existing_folder_of(path);
    if (::stat(folder.c_str(), &status) != 0)
        throw_unwritable(path, "folder " + folder + ": " + reason_of(errno));
    if (!S_ISDIR(status.st_mode))
        throw_unwritable(path, "folder " + folder + ": " + reason_of(ENOTDIR));
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        throw_unwritable(path, "folder " + folder + ": " + reason_of(errno));
    }
}

void require_writable_folder(const std::string& folder, const std::vector<std::string>& paths,
                             bool force) {
    struct stat status {};
    if (::lstat(folder.c_str(), &status) != 0) {
        require_writable(folder, force);
        return;
    }
    if (::stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode)) {
        throw_unwritable(folder, "it exists and is not a folder; choose another name");
    }
    if (!force) refuse_existing(folder);
    for (const std::string& path : paths) {
        require_writable(path, force);
    }
}

}  // namespace pcvt
