// Calls of the system that emscripten declares and does not have. pcvt has another way for each
// call that is missing.
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cfenv>

namespace {

int fail() {
    errno = ENOSYS;
    return -1;
}

}  // namespace

extern "C" {

/// Defined nowhere: a program that sets the rounding mode does not link, so that no interval
/// arithmetic slips in.
int webassembly_has_no_rounding_modes();
int fesetround(int /*mode*/) { return webassembly_has_no_rounding_modes(); }

int flock(int /*file*/, int /*operation*/) { return fail(); }

int link(const char* /*from*/, const char* /*to*/) { return fail(); }

/// Returns the address space of WebAssembly, against which pcvt checks the memory that a run needs.
int getrlimit(int resource, rlimit* limit) {
    if (resource != RLIMIT_AS) return fail();
    limit->rlim_cur = limit->rlim_max = rlim_t{1} << 32;
    return 0;
}

}  // extern "C"
