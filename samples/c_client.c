/* Uses pcvt from C99: optimises sites on an oblique torus, prints the seam of the tile of their
 * cells, and writes the tile and the sites.
 *
 *     cc -std=c99 c_client.c $(pkg-config --cflags --libs pcvt) -o c_client
 *     c_client N SEED TILE SITES.txt
 */
#include <pcvt.h>
#include <stdio.h>
#include <stdlib.h>

/* Prints the first iterations. A nonzero return value would cancel the run. */
static int show(const pcvt_progress* progress, void* data) {
    (void)data;
    if (progress->iteration < 3) {
        printf("iteration %d: residual %.3g\n", (int)progress->iteration, progress->residual);
    }
    return 0;
}

static void stop_on_error(pcvt_status status) {
    if (status >= 0) return;
    fprintf(stderr, "c_client: %s: %s\n", pcvt_status_text(status), pcvt_last_error());
    exit(1);
}

/* Prints each identified pair of boundary edges: w0 -> w1 is v0 -> v1 moved by i a + j b. */
static void walk_seam(const pcvt_tile* tile) {
    int32_t p;
    for (p = 0; p < tile->n_edge_pairs; ++p) {
        const pcvt_edge_pair* pair = &tile->edge_pairs[p];
        const double x = pair->i * tile->lattice[0] + pair->j * tile->lattice[2];
        const double y = pair->i * tile->lattice[1] + pair->j * tile->lattice[3];
        printf("edge %d-%d + (%g, %g) = edge %d-%d\n", (int)pair->v0, (int)pair->v1, x, y,
               (int)pair->w0, (int)pair->w1);
    }
}

int main(int argc, char** argv) {
    pcvt_options options;
    pcvt_result* result;
    pcvt_tile tile;
    pcvt_statistics figures;
    if (argc != 5) {
        fprintf(stderr, "usage: c_client N SEED TILE SITES.txt\n");
        return 2;
    }
    stop_on_error(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION));
    options.n_sites = (int32_t)strtol(argv[1], NULL, 10);
    options.seed = strtoull(argv[2], NULL, 10);
    options.lattice[2] = 0.37; /* b = (0.37, 0.81); a stays (1, 0) */
    options.lattice[3] = 0.81;
    options.progress = show;
    stop_on_error(pcvt_generate(&options, &result));

    stop_on_error(pcvt_get_statistics(result, &figures, sizeof figures));
    printf("%d of %d cells are hexagons; energy %.6f of the hexagonal bound\n",
           (int)figures.n_hexagons, (int)figures.n_sites, figures.energy / figures.energy_bound);

    stop_on_error(pcvt_get_tile(result, PCVT_VORONOI, PCVT_WHOLE, &tile, sizeof tile));
    walk_seam(&tile);

    stop_on_error(pcvt_write(result, argv[3], NULL));
    stop_on_error(pcvt_write(result, argv[4], NULL));
    pcvt_free(result);
    return 0;
}
