#pragma once

#include <string>
#include <vector>

namespace pcvt {

/// Checks that `path` can be written; call it for every target before any computation.
///
/// Example usage:
///     require_writable("tile.obj", false);
///
/// @param force  whether an existing target may be replaced.
/// @throws OutputExists if the target exists and `force` is not set.
/// @throws OutputError if the target is a folder, or if its folder is not writable, or is missing
///         and cannot be made.
void require_writable(const std::string& path, bool force);

/// The same check for a folder and for `paths`, the files to be staged in it; `force` allows files
/// in an existing folder to be replaced.
void require_writable_folder(const std::string& folder, const std::vector<std::string>& paths,
                             bool force);

/// Returns the folder of a path, "." if it names none.
std::string folder_of(const std::string& path);
/// Returns the folder of `path`, or the nearest folder above it if that one is missing. A folder
/// that cannot be examined is returned, so that its use reports the reason.
std::string existing_folder_of(const std::string& path);

[[noreturn]] void throw_unwritable(const std::string& path, const std::string& reason);
[[noreturn]] void refuse_existing(const std::string& path);

}  // namespace pcvt
