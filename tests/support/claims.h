/* Shared by the C99 tests of the C interface: counted claims, and runs. */
#ifndef PCVT_TESTS_CLAIMS_H
#define PCVT_TESTS_CLAIMS_H

#include <pcvt.h>
#include <stdio.h>
#include <string.h>

/* Counters of this program, which is a single file. */
static int n_failed = 0;

static inline void check(int holds, const char* claim, int line) {
    if (holds) return;
    printf("line %d: %s; last error: %s\n", line, claim, pcvt_last_error());
    ++n_failed;
}

#define CHECK(claim) check((claim) != 0, #claim, __LINE__)

static inline pcvt_options options_for(int32_t n_sites) {
    pcvt_options options;
    CHECK(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION) == PCVT_OK);
    options.n_sites = n_sites;
    return options;
}

static inline pcvt_result* generated(const pcvt_options* options) {
    pcvt_result* result = NULL;
    CHECK(pcvt_generate(options, &result) == PCVT_OK);
    CHECK(result != NULL);
    CHECK(strcmp(pcvt_last_error(), "") == 0);
    return result;
}

/* Generates, and expects a status without a result and a message that contains `word`. */
static inline void refused(const pcvt_options* options, pcvt_status status, const char* word,
                           int line) {
    pcvt_result* result = (pcvt_result*)&n_failed;
    check(pcvt_generate(options, &result) == status, "the status", line);
    check(result == NULL, "no result", line);
    check(strstr(pcvt_last_error(), word) != NULL, word, line);
}

#define REFUSED(options, status, word) refused(options, status, word, __LINE__)

static inline int end_of_claims(void) {
    printf("%d claims failed\n", n_failed);
    return n_failed != 0;
}

#endif
