/* Runs in three dimensions for the C99 tests of the C interface. */
#ifndef PCVT_TESTS_SPACE_CLAIMS_H
#define PCVT_TESTS_SPACE_CLAIMS_H

#include "tests/support/claims.h"

static inline pcvt_options space_options_for(int32_t n_sites) {
    pcvt_options options = options_for(n_sites);
    options.dimension = 3;
    return options;
}

static inline pcvt_cells cells_of(const pcvt_result* result) {
    pcvt_cells cells;
    memset(&cells, 0, sizeof cells);
    CHECK(pcvt_get_cells(result, &cells, sizeof cells) == PCVT_OK);
    return cells;
}

/* Removes a file and returns whether there was one. */
static inline int removes_file(const char* path) { return remove(path) == 0; }

#endif
