/* Makes chosen allocations of a program fail.
 *
 *     LD_PRELOAD=liballocation_shim.so FAULT_ALLOCATION=17 pcvt mesh ...
 *
 * The environment variables, which are read at the first allocation:
 *   FAULT_ALLOCATION=K   allocation K fails, counted from 1 over all threads
 *   FAULT_FOREVER=1      and so does every later one
 *   FAULT_COUNT=FILE     receives the number of allocations when the program ends
 *
 * A program that is linked with the shim chooses by fault_arm() instead. */
#include "tests/fault/allocation_shim.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The allocator of glibc under the names that it keeps for this purpose. */
extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);
extern void __libc_free(void*);

static long n_allocations;
static long n_live;
static long failing = -1;
static int forever;

static long read_number(const char* name) {
    const char* text = getenv(name);
    return text == NULL ? 0 : atol(text);
}

/* Counts one allocation and returns whether it has to fail. */
static int must_fail(void) {
    long k;
    if (failing < 0) {
        forever = read_number("FAULT_FOREVER") != 0;
        failing = read_number("FAULT_ALLOCATION");
    }
    k = __atomic_add_fetch(&n_allocations, 1, __ATOMIC_RELAXED);
    if (failing == 0 || k < failing || (k > failing && !forever)) return 0;
    errno = ENOMEM;
    return 1;
}

static void* counted(void* block) {
    if (block != NULL) __atomic_add_fetch(&n_live, 1, __ATOMIC_RELAXED);
    return block;
}

void fault_arm(long allocation, int for_ever) {
    forever = for_ever;
    n_allocations = 0;
    failing = allocation;
}

long fault_allocations(void) { return n_allocations; }

long fault_live_blocks(void) { return n_live; }

void* malloc(size_t size) { return must_fail() ? NULL : counted(__libc_malloc(size)); }

void* calloc(size_t n, size_t size) { return must_fail() ? NULL : counted(__libc_calloc(n, size)); }

void* realloc(void* block, size_t size) {
    void* moved;
    if (must_fail()) return NULL;
    moved = __libc_realloc(block, size);
    if (block == NULL) return counted(moved);
    if (size == 0) __atomic_sub_fetch(&n_live, 1, __ATOMIC_RELAXED);
    return moved;
}

void* reallocarray(void* block, size_t n, size_t size) {
    if (size != 0 && n > (size_t)-1 / size) {
        errno = ENOMEM;
        return NULL;
    }
    return realloc(block, n * size);
}

void* memalign(size_t alignment, size_t size) {
    return must_fail() ? NULL : counted(__libc_memalign(alignment, size));
}

void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }

int posix_memalign(void** block, size_t alignment, size_t size) {
    void* made = memalign(alignment, size);
    if (made == NULL) return ENOMEM;
    *block = made;
    return 0;
}

void free(void* block) {
    if (block != NULL) __atomic_sub_fetch(&n_live, 1, __ATOMIC_RELAXED);
    __libc_free(block);
}

__attribute__((destructor)) static void write_count(void) {
    const char* path = getenv("FAULT_COUNT");
    char text[32];
    int file;
    if (path == NULL) return;
    file = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0) return;
    snprintf(text, sizeof text, "%ld\n", n_allocations);
    if (write(file, text, strlen(text)) < 0) perror(path);
    close(file);
}
