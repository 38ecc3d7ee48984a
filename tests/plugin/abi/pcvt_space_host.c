/* Writes the files of a run in three dimensions, with the options that the command has.
 *
 *     pcvt_space_host N SEED START SOLVER MAX_ITERATIONS AX AY AZ BX BY BZ CX CY CZ FILE...
 */
#include <pcvt.h>
#include <stdio.h>
#include <stdlib.h>

static void stop_on_error(pcvt_status status) {
    if (status >= 0) return;
    fprintf(stderr, "pcvt_space_host: %s: %s\n", pcvt_status_text(status), pcvt_last_error());
    exit(1);
}

int main(int argc, char** argv) {
    pcvt_options options;
    pcvt_result* result;
    if (argc < 16) {
        fprintf(stderr,
                "usage: pcvt_space_host N SEED START SOLVER MAX_ITERATIONS AX ... CZ FILE...\n");
        return 2;
    }
    stop_on_error(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION));
    options.dimension = 3;
    options.n_sites = (int32_t)strtol(argv[1], NULL, 10);
    options.seed = strtoull(argv[2], NULL, 10);
    options.start = (int32_t)strtol(argv[3], NULL, 10);
    options.solver = (int32_t)strtol(argv[4], NULL, 10);
    options.max_iterations = (int32_t)strtol(argv[5], NULL, 10);
    for (int k = 0; k < 9; ++k) options.lattice3[k] = strtod(argv[6 + k], NULL);
    stop_on_error(pcvt_generate(&options, &result));
    for (int k = 15; k < argc; ++k) stop_on_error(pcvt_write(result, argv[k], NULL));
    pcvt_free(result);
    return 0;
}
