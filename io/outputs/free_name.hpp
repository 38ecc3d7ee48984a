#pragma once

namespace pcvt {

/// Renames a file or folder unless `to` exists: renameat2(2) with RENAME_NOREPLACE.
/// @returns  0, or -1 with errno EEXIST if the name is taken; EINVAL or ENOSYS if the file system
///           lacks this call.
int rename_to_free_name(const char* from, const char* to) noexcept;

}  // namespace pcvt
