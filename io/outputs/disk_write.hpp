#pragma once

#include <string_view>

namespace pcvt {

/// Writes a whole file, with checkpoints between its pieces, waits until it is on the disk, and
/// closes it on every way out. A disk may take seconds for a large file.
///
/// Example usage:
///     int file = -1;
///     int error = create_file("tile.obj", file);
///     if (error == 0) error = write_to_disk(file, bytes);
///
/// @param file  open for writing, at its beginning.
/// @returns     0 or the system's error.
/// @throws Cancelled
int write_to_disk(int file, std::string_view bytes);

}  // namespace pcvt
