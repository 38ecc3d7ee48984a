/* Loads, uses and unloads the library repeatedly: it must leave the process without leaks.
 *
 *     pcvt_loading_test LIBRARY CYCLES
 */
#define _POSIX_C_SOURCE 200809L
#include <dlfcn.h>
#include <pcvt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* The address sanitizer delays the release of freed memory, and detects leaks itself. */
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define KEEPS_FREED_MEMORY 1
#endif
#endif
#ifndef KEEPS_FREED_MEMORY
#define KEEPS_FREED_MEMORY 0
#endif

typedef pcvt_status (*init_function)(pcvt_options*, size_t, uint32_t);
typedef pcvt_status (*generate_function)(const pcvt_options*, pcvt_result**);
typedef pcvt_status (*tile_function)(const pcvt_result*, int32_t, int32_t, pcvt_tile*, size_t);
typedef void (*free_function)(pcvt_result*);
typedef const char* (*error_function)(void);

static void fail(const char* what) {
    printf("%s\n", what);
    exit(1);
}

/* Copies the function's address through memory: C99 has no cast from object to function pointers.
 */
static void find(void* library, const char* name, void* function) {
    void* symbol = dlsym(library, name);
    if (symbol == NULL) fail(dlerror());
    memcpy(function, &symbol, sizeof symbol);
}

static void cycle(const char* path) {
    init_function init;
    generate_function generate;
    tile_function get_tile;
    free_function free_result;
    error_function last_error;
    pcvt_options options;
    pcvt_result* result;
    pcvt_tile tile;
    void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) fail(dlerror());
    find(library, "pcvt_options_init", &init);
    find(library, "pcvt_generate", &generate);
    find(library, "pcvt_get_tile", &get_tile);
    find(library, "pcvt_free", &free_result);
    find(library, "pcvt_last_error", &last_error);
    if (init(&options, sizeof options, PCVT_ABI_VERSION) != PCVT_OK) fail("init failed");
    options.n_sites = 9;
    options.n_threads = 2;
    if (generate(&options, &result) != PCVT_OK) fail("generate failed");
    if (get_tile(result, PCVT_VORONOI, PCVT_WHOLE, &tile, sizeof tile) != PCVT_OK) fail("no tile");
    free_result(result);
    if (generate(NULL, NULL) != PCVT_ERROR_ARGUMENT || *last_error() == '\0')
        fail("null was taken");
    if (dlclose(library) != 0) fail(dlerror());
}

/* Returns the number of resident pages of this process. */
static long resident_pages(void) {
    long size = 0, resident = 0;
    FILE* file = fopen("/proc/self/statm", "r");
    if (file == NULL || fscanf(file, "%ld %ld", &size, &resident) != 2) fail("no /proc/self/statm");
    fclose(file);
    return resident;
}

static int is_mapped(const char* name) {
    char line[4096];
    int found = 0;
    FILE* file = fopen("/proc/self/maps", "r");
    if (file == NULL) fail("no /proc/self/maps");
    while (fgets(line, sizeof line, file) != NULL) found |= strstr(line, name) != NULL;
    fclose(file);
    return found;
}

int main(int argc, char** argv) {
    long early = 0, late = 0, n_cycles = 0;
    if (argc != 3) fail("usage: pcvt_loading_test LIBRARY CYCLES");
    n_cycles = strtol(argv[2], NULL, 10);
    for (long k = 0; k < n_cycles; ++k) {
        cycle(argv[1]);
        if (k == n_cycles / 10) early = resident_pages();
    }
    late = resident_pages();
    printf("%ld pages after a tenth of the cycles, %ld at the end\n", early, late);
    if (is_mapped("libpcvt")) fail("the library stays loaded");
    if (KEEPS_FREED_MEMORY) return 0;
    /* A leak of 100 bytes per cycle would exceed the limit in 2000 cycles. */
    return (late - early) * sysconf(_SC_PAGESIZE) > 90 * n_cycles ? 1 : 0;
}
