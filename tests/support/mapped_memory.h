/* The memory of a process, for tests of refusals by an estimate. */
#ifndef PCVT_TESTS_MAPPED_MEMORY_H
#define PCVT_TESTS_MAPPED_MEMORY_H

#include <stdio.h>

/* The memory that this process has mapped, in bytes. */
static inline size_t mapped_memory(void) {
    char line[128];
    size_t kilobytes = 0;
    FILE* file = fopen("/proc/self/status", "r");
    if (file == NULL) return 0;
    while (fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "VmSize: %zu", &kilobytes) == 1) break;
    }
    fclose(file);
    return 1024 * kilobytes;
}

#endif
