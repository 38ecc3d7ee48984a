#pragma once

#include <string>
#include <string_view>

namespace pcvt {

/// The calls of the system from which a set of outputs is made. They return 0 or the system's
/// error, allocate nothing and throw nothing.
///
/// Example usage:
///     int file = -1;
///     int error = create_file("tile.obj", file);
///     if (error == 0) error = write_all(file, bytes);
///     if (error == 0) error = sync_file(file);

/// The size of a file and the time of its last change: they differ once somebody else has written
/// it. Renames and links do not change them.
struct FileStamp {
    long long size = 0;
    long long seconds = 0;
    long long nanoseconds = 0;
    bool operator==(const FileStamp&) const = default;
};

/// The status of the file with a name; symbolic links are not followed.
struct NameStatus {
    bool exists = false;
    bool is_folder = false;
    FileStamp stamp;
    unsigned long long device = 0;
    unsigned long long inode = 0;
    bool is_same_file(const NameStatus& other) const {
        return exists && other.exists && device == other.device && inode == other.inode;
    }
};

/// Looks a name up. A name that does not exist counts as success.
int look_up(const char* path, NameStatus& status) noexcept;

/// Opens a file whose name must be free. The descriptor is none of the three standard ones, so that
/// a host whose standard output is closed prints nothing into the file.
int create_file(const char* path, int& file) noexcept;
/// Opens a regular file, for reading and writing, under the same rule.
int open_file(const char* path, int& file) noexcept;
/// Opens a regular file that serves as a lock, and makes it where it is missing. A file of another
/// user may be opened only for reading.
int open_lock_file(const char* path, int& file, bool& is_fresh) noexcept;
bool is_of_this_user(int file) noexcept;
/// Locks a file against all other descriptors if it still has a name. Returns EWOULDBLOCK if it is
/// locked, or has lost its name since it was opened.
int try_lock(int file) noexcept;
void unlock(int file) noexcept;
/// Whether an error says that the file system has no locks, and not that another run holds one.
bool lacks_locks(int error) noexcept;
/// Closes a descriptor and sets it to -1; does nothing for -1.
void close_file(int& file) noexcept;
int write_all(int file, std::string_view bytes) noexcept;
/// Waits until the file is on the disk. Files that cannot be synchronised count as success.
int sync_file(int file) noexcept;
/// Waits until the names in a folder are on the disk. A folder that cannot be opened for reading
/// counts as success.
int sync_folder(const char* path) noexcept;
/// Replaces the content of an open file by `bytes`, and waits until they are on the disk.
int overwrite(int file, std::string_view bytes) noexcept;

/// Gives a file, or a folder, a name that must be free.
int move_file_to_free_name(const char* from, const char* to) noexcept;
int move_folder_to_free_name(const char* from, const char* to) noexcept;
/// Removes a name; one that is free already counts as success.
int remove_name(const char* path) noexcept;

/// The words of the system for an error.
std::string reason_of(int error);

}  // namespace pcvt
