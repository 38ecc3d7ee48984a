/* Writes the optimised sites that a C host gets to standard output: 2 n doubles in memory layout.
 *
 *     pcvt_sites N SEED AX AY BX BY SYMMETRY [DENSITY]
 */
#include <pcvt.h>
#include <stdio.h>
#include <stdlib.h>

static void stop_on_error(pcvt_status status) {
    if (status == PCVT_OK) return;
    fprintf(stderr, "pcvt_sites: %s: %s\n", pcvt_status_text(status), pcvt_last_error());
    exit(1);
}

int main(int argc, char** argv) {
    pcvt_options options;
    pcvt_result* result;
    pcvt_sites sites;
    if (argc != 8 && argc != 9) {
        fprintf(stderr, "usage: pcvt_sites N SEED AX AY BX BY SYMMETRY [DENSITY]\n");
        return 2;
    }
    stop_on_error(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION));
    options.n_sites = (int32_t)strtol(argv[1], NULL, 10);
    options.seed = strtoull(argv[2], NULL, 10);
    for (int k = 0; k < 4; ++k) options.lattice[k] = strtod(argv[3 + k], NULL);
    options.symmetry = (int32_t)strtol(argv[7], NULL, 10);
    if (argc == 9) options.density_source = argv[8];
    stop_on_error(pcvt_generate(&options, &result));
    stop_on_error(pcvt_get_sites(result, &sites, sizeof sites));
    const size_t n_doubles = 2 * (size_t)sites.n_sites;
    const int is_written = fwrite(sites.points, sizeof(double), n_doubles, stdout) == n_doubles;
    pcvt_free(result);
    return is_written && fflush(stdout) == 0 ? 0 : 1;
}
