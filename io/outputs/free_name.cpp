#include "io/outputs/free_name.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdio>

namespace pcvt {

#if defined(RENAME_NOREPLACE)

int rename_to_free_name(const char* from, const char* to) noexcept {
    return ::renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE);
}

#elif defined(__EMSCRIPTEN__)

// The files of a WebAssembly module belong to its one thread: nothing appears before the rename.
int rename_to_free_name(const char* from, const char* to) noexcept {
    struct stat found {};
    if (::lstat(to, &found) != 0) return errno == ENOENT ? ::rename(from, to) : -1;
    errno = EEXIST;
    return -1;
}

#else

int rename_to_free_name(const char* /*from*/, const char* /*to*/) noexcept {
    errno = ENOSYS;
    return -1;
}

#endif

}  // namespace pcvt
