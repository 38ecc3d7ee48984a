/* A library for LD_PRELOAD that lets one call of the system fail, or all from one on, or that kills
 * the process before or after one.
 *
 *     FAULT_LIST=FILE   writes the name of each call to FILE, one a line, at the end of the process
 *     FAULT_CALL=K      the call in question, counted from 1
 *     FAULT_MODE        once, from (this call and all later ones), before, after (the kill)
 *     FAULT_ERROR       the error of calls that fail, a number
 *
 * Only calls of the program and its libraries to the C library are seen, not those inside of it. */
#define _GNU_SOURCE
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

enum { MOST_CALLS = 1 << 16 };
enum action { WORK, FAIL, KILL_AFTER };

static atomic_int n_calls;
static const char* names[MOST_CALLS];
static int chosen, fault_error;
static const char* mode = "";

static int number(const char* name) {
    const char* text = getenv(name);
    return text == NULL ? 0 : atoi(text);
}

__attribute__((constructor)) static void begin(void) {
    chosen = number("FAULT_CALL");
    fault_error = number("FAULT_ERROR");
    if (getenv("FAULT_MODE") != NULL) mode = getenv("FAULT_MODE");
}

__attribute__((destructor)) static void end(void) {
    const char* path = getenv("FAULT_LIST");
    const int n = n_calls < MOST_CALLS ? n_calls : MOST_CALLS;
    long file;
    int k;
    if (path == NULL) return;
    file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    for (k = 0; k < n; ++k) {
        syscall(SYS_write, file, names[k], strlen(names[k]));
        syscall(SYS_write, file, "\n", 1);
    }
    syscall(SYS_close, file);
}

static enum action count(const char* name) {
    const int k = ++n_calls;
    if (k <= MOST_CALLS) names[k - 1] = name;
    if (chosen == 0 || k < chosen) return WORK;
    if (strcmp(mode, "from") == 0) return FAIL;
    if (k > chosen) return WORK;
    if (strcmp(mode, "before") == 0) raise(SIGKILL);
    return strcmp(mode, "after") == 0 ? KILL_AFTER : FAIL;
}

/* The body of a replaced function: FAILED is its value when it fails. */
#define REPLACE(type, name, failed, parameters, ...)                \
    {                                                               \
        static type(*real) parameters;                              \
        const enum action act = count(#name);                       \
        type result;                                                \
        if (act == FAIL) {                                          \
            errno = fault_error;                                    \
            return failed;                                          \
        }                                                           \
        if (real == NULL) *(void**)&real = dlsym(RTLD_NEXT, #name); \
        result = real(__VA_ARGS__);                                 \
        if (act == KILL_AFTER) raise(SIGKILL);                      \
        return result;                                              \
    }

static mode_t mode_of(int flags, va_list rest) {
    return flags & O_CREAT ? va_arg(rest, mode_t) : 0;
}

#define OPEN(name)                                                         \
    int name(const char* path, int flags, ...) {                           \
        va_list rest;                                                      \
        mode_t bits;                                                       \
        va_start(rest, flags);                                             \
        bits = mode_of(flags, rest);                                       \
        va_end(rest);                                                      \
        REPLACE(int, name, -1, (const char*, int, ...), path, flags, bits) \
    }
#define OPEN_AT(name)                                                                   \
    int name(int folder, const char* path, int flags, ...) {                            \
        va_list rest;                                                                   \
        mode_t bits;                                                                    \
        va_start(rest, flags);                                                          \
        bits = mode_of(flags, rest);                                                    \
        va_end(rest);                                                                   \
        REPLACE(int, name, -1, (int, const char*, int, ...), folder, path, flags, bits) \
    }
OPEN(open)
OPEN(open64)
OPEN_AT(openat)
OPEN_AT(openat64)

/* As on Linux, a descriptor is closed even where the call reports an error. */
int close(int file) {
    const enum action act = count("close");
    const int result = (int)syscall(SYS_close, file);
    if (act == KILL_AFTER) raise(SIGKILL);
    if (act != FAIL) return result;
    errno = fault_error;
    return -1;
}

ssize_t read(int file, void* bytes, size_t n)
    REPLACE(ssize_t, read, -1, (int, void*, size_t), file, bytes, n) ssize_t
    write(int file, const void* bytes, size_t n)
        REPLACE(ssize_t, write, -1, (int, const void*, size_t), file, bytes, n) ssize_t
    pread(int file, void* bytes, size_t n, off_t at)
        REPLACE(ssize_t, pread, -1, (int, void*, size_t, off_t), file, bytes, n, at) ssize_t
    pwrite(int file, const void* bytes, size_t n, off_t at)
        REPLACE(ssize_t, pwrite, -1, (int, const void*, size_t, off_t), file, bytes, n, at) off_t
    lseek(int file, off_t at, int from) REPLACE(off_t, lseek, -1, (int, off_t, int), file, at,
                                                from) int ftruncate(int file, off_t size)
        REPLACE(int, ftruncate, -1, (int, off_t), file, size) int fsync(int file) REPLACE(
            int, fsync, -1, (int),
            file) int flock(int file, int how) REPLACE(int, flock, -1, (int, int), file,
                                                       how) int rename(const char* from,
                                                                       const char* to)
            REPLACE(int, rename, -1, (const char*, const char*), from,
                    to) int renameat2(int a, const char* from, int b, const char* to,
                                      unsigned flags)
                REPLACE(int, renameat2, -1, (int, const char*, int, const char*, unsigned), a, from,
                        b, to,
                        flags) int link(const char* from,
                                        const char* to) REPLACE(int, link, -1,
                                                                (const char*, const char*), from,
                                                                to) int unlink(const char* path)
                    REPLACE(int, unlink, -1, (const char*),
                            path) int unlinkat(int folder, const char* path, int flags)
                        REPLACE(int, unlinkat, -1, (int, const char*, int), folder, path,
                                flags) int mkdir(const char* path, mode_t bits)
                            REPLACE(int, mkdir, -1, (const char*, mode_t), path, bits) int rmdir(
                                const char* path) REPLACE(int, rmdir, -1, (const char*),
                                                          path) int access(const char* path,
                                                                           int how)
                                REPLACE(int, access, -1, (const char*, int), path,
                                        how) int stat(const char* path, struct stat* status)
                                    REPLACE(int, stat, -1, (const char*, struct stat*), path,
                                            status) int lstat(const char* path, struct stat* status)
                                        REPLACE(int, lstat, -1, (const char*, struct stat*), path,
                                                status) int fstat(int file, struct stat* status)
                                            REPLACE(int, fstat, -1, (int, struct stat*), file,
                                                    status) DIR* opendir(const char* path)
                                                REPLACE(DIR*, opendir, NULL, (const char*),
                                                        path) DIR* fdopendir(int file)
                                                    REPLACE(
                                                        DIR*, fdopendir, NULL, (int),
                                                        file) struct dirent* readdir(DIR* folder)
                                                        REPLACE(struct dirent*, readdir, NULL,
                                                                (DIR*),
                                                                folder) void* mmap(void* at,
                                                                                   size_t n,
                                                                                   int protection,
                                                                                   int flags,
                                                                                   int file,
                                                                                   off_t from)
                                                            REPLACE(void*, mmap, MAP_FAILED,
                                                                    (void*, size_t, int, int, int,
                                                                     off_t),
                                                                    at, n, protection, flags, file,
                                                                    from)
