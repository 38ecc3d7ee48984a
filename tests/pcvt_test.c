/* The C interface as a C99 host sees it: results, seams, refusals, each with its documented status.
 */
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <pcvt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int n_failed = 0;

static void check(int holds, const char* claim, int line) {
    if (holds) return;
    printf("line %d: %s; last error: %s\n", line, claim, pcvt_last_error());
    ++n_failed;
}

#define CHECK(claim) check((claim) != 0, #claim, __LINE__)

static pcvt_options options_for(int32_t n_sites) {
    pcvt_options options;
    CHECK(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION) == PCVT_OK);
    options.n_sites = n_sites;
    return options;
}

static pcvt_result* generated(const pcvt_options* options) {
    pcvt_result* result = NULL;
    CHECK(pcvt_generate(options, &result) == PCVT_OK);
    CHECK(result != NULL);
    CHECK(strcmp(pcvt_last_error(), "") == 0);
    return result;
}

/* Generates, expects a status without a result, and a text that holds `word`. */
static void refused(const pcvt_options* options, pcvt_status status, const char* word, int line) {
    pcvt_result* result = (pcvt_result*)&n_failed;
    check(pcvt_generate(options, &result) == status, "the status", line);
    check(result == NULL, "no result", line);
    check(strstr(pcvt_last_error(), word) != NULL, word, line);
}

#define REFUSED(options, status, word) refused(options, status, word, __LINE__)

/* How far position(w) is from position(v) + i a + j b, in units of the last place. */
static double misfit(const pcvt_tile* tile, int32_t v, int32_t w, int32_t i, int32_t j) {
    double largest = 0, worst = 0;
    for (int32_t k = 0; k < 2 * tile->n_vertices; ++k) {
        largest = fmax(largest, fabs(tile->points[k]));
    }
    for (int k = 0; k < 2; ++k) {
        const double there =
            tile->points[2 * v + k] + i * tile->lattice[k] + j * tile->lattice[2 + k];
        worst = fmax(worst, fabs(tile->points[2 * w + k] - there));
    }
    return worst / (DBL_EPSILON * largest);
}

static int has_edge(const pcvt_tile* tile, int32_t from, int32_t to) {
    for (int32_t f = 0; f < tile->n_faces; ++f) {
        int32_t previous = tile->corners[tile->face_begin[f + 1] - 1];
        for (int32_t c = tile->face_begin[f]; c < tile->face_begin[f + 1]; ++c) {
            if (previous == from && tile->corners[c] == to) return 1;
            previous = tile->corners[c];
        }
    }
    return 0;
}

/* Edges of faces that have no face on their other side. */
static int32_t n_boundary_edges(const pcvt_tile* tile) {
    int32_t n = 0;
    for (int32_t f = 0; f < tile->n_faces; ++f) {
        int32_t previous = tile->corners[tile->face_begin[f + 1] - 1];
        for (int32_t c = tile->face_begin[f]; c < tile->face_begin[f + 1]; ++c) {
            if (!has_edge(tile, tile->corners[c], previous)) ++n;
            previous = tile->corners[c];
        }
    }
    return n;
}

static void check_seam(const pcvt_tile* tile) {
    CHECK(tile->n_edge_pairs > 0);
    CHECK(n_boundary_edges(tile) == 2 * tile->n_edge_pairs);
    for (int32_t p = 0; p < tile->n_edge_pairs; ++p) {
        const pcvt_edge_pair pair = tile->edge_pairs[p];
        CHECK(has_edge(tile, pair.v0, pair.v1) && !has_edge(tile, pair.v1, pair.v0));
        CHECK(has_edge(tile, pair.w1, pair.w0) && !has_edge(tile, pair.w0, pair.w1));
        CHECK(pair.i != 0 || pair.j != 0);
        CHECK(misfit(tile, pair.v0, pair.w0, pair.i, pair.j) < 4);
        CHECK(misfit(tile, pair.v1, pair.w1, pair.i, pair.j) < 4);
    }
    for (int32_t v = 0; v < tile->n_vertices; ++v) {
        const int32_t* offset = &tile->vertex_offset[2 * v];
        CHECK(tile->vertex_orbit[v] <= v);
        CHECK(misfit(tile, tile->vertex_orbit[v], v, offset[0], offset[1]) < 4);
    }
}

static double area(const pcvt_tile* tile) {
    double sum = 0;
    for (int32_t f = 0; f < tile->n_faces; ++f) {
        const double* from = &tile->points[2 * tile->corners[tile->face_begin[f + 1] - 1]];
        for (int32_t c = tile->face_begin[f]; c < tile->face_begin[f + 1]; ++c) {
            const double* to = &tile->points[2 * tile->corners[c]];
            sum += (from[0] * to[1] - to[0] * from[1]) / 2;
            from = to;
        }
    }
    return sum;
}

static void every_identified_edge_pair_is_a_translation(void) {
    const double lattice[4] = {1, 0, 0.37, 0.81};
    pcvt_options options = options_for(1000);
    memcpy(options.lattice, lattice, sizeof lattice);
    options.tolerance = 1e-4;
    options.columns = 2;
    pcvt_result* result = generated(&options);
    for (int32_t kind = PCVT_VORONOI; kind <= PCVT_DELAUNAY; ++kind) {
        pcvt_tile tile;
        CHECK(pcvt_get_tile(result, kind, PCVT_WHOLE, &tile, sizeof tile) == PCVT_OK);
        CHECK(tile.n_faces == (kind == PCVT_VORONOI ? 2000 : 4000));
        CHECK(tile.lattice[0] == 2 && tile.lattice[2] == 0.37);
        CHECK((tile.face_site == NULL) == (kind == PCVT_DELAUNAY));
        CHECK((tile.vertex_site == NULL) == (kind == PCVT_VORONOI));
        CHECK(fabs(area(&tile) - 2 * 0.81) < 1e-12);
        check_seam(&tile);
    }
    pcvt_free(result);
}

static void meshes_on_the_torus_are_closed(void) {
    pcvt_options options = options_for(100);
    pcvt_result* result = generated(&options);
    for (int32_t kind = PCVT_VORONOI; kind <= PCVT_DELAUNAY; ++kind) {
        pcvt_mesh mesh;
        CHECK(pcvt_get_mesh(result, kind, &mesh, sizeof mesh) == PCVT_OK);
        CHECK(mesh.kind == kind && mesh.face_begin[mesh.n_faces] == mesh.n_corners);
        CHECK(mesh.n_vertices - mesh.n_corners / 2 + mesh.n_faces == 0);
        for (int32_t c = 0; c < mesh.n_corners; ++c) {
            CHECK(mesh.opposite[c] != c && mesh.opposite[mesh.opposite[c]] == c);
        }
    }
    pcvt_free(result);
}

static void statistics_tell_the_run(void) {
    pcvt_options options = options_for(100);
    pcvt_statistics figures;
    pcvt_result* result = generated(&options);
    CHECK(pcvt_get_statistics(result, &figures, sizeof figures) == PCVT_OK);
    CHECK(figures.n_sites == 100 && figures.stop == PCVT_STOP_CONVERGED);
    CHECK(figures.residual <= 1e-6 && figures.rms_residual <= figures.residual);
    CHECK(figures.energy >= figures.energy_bound && figures.energy < 1.1 * figures.energy_bound);
    CHECK(figures.iterations > 1 && figures.evaluations >= figures.iterations);
    int32_t n_cells = 0;
    for (int32_t k = 0; k < figures.n_valences; ++k) n_cells += figures.valences[k];
    CHECK(n_cells == 100 && figures.n_hexagons == figures.valences[6]);
    pcvt_free(result);
}

static void results_do_not_depend_on_threads_or_on_where_sites_come_from(void) {
    pcvt_options options = options_for(1000);
    pcvt_sites drawn, given;
    options.max_iterations = 0;
    pcvt_result* first = generated(&options);
    CHECK(pcvt_get_sites(first, &drawn, sizeof drawn) == PCVT_OK);
    options.n_threads = 3;
    options.sites = drawn.points;
    pcvt_result* second = generated(&options);
    CHECK(pcvt_get_sites(second, &given, sizeof given) == PCVT_OK);
    CHECK(given.n_sites == 1000 && drawn.points != given.points);
    for (int k = 0; k < 2000; ++k) CHECK(fabs(drawn.points[k] - given.points[k]) < 1e-15);
    pcvt_free(first);
    pcvt_free(second);
}

typedef struct watch {
    int n_calls;
    int rounding;
} watch;

static int cancel_at_7(const pcvt_progress* progress, void* data) {
    watch* seen = data;
    seen->rounding = fegetround();
    ++seen->n_calls;
    return progress->struct_size >= sizeof *progress && progress->iteration == 7;
}

static void cancelling_at_iteration_7_gives_the_cancelled_status(void) {
    pcvt_options options = options_for(1000);
    watch seen = {0, 0};
    options.progress = cancel_at_7;
    options.progress_data = &seen;
    REFUSED(&options, PCVT_CANCELLED, "cancelled");
    CHECK(seen.n_calls == 8); /* 0 to 7 */
}

static void the_iteration_limit_gives_a_result_that_is_not_converged(void) {
    pcvt_options options = options_for(300);
    pcvt_result* result = NULL;
    options.max_iterations = 3;
    CHECK(pcvt_generate(&options, &result) == PCVT_NOT_CONVERGED);
    CHECK(result != NULL);
    CHECK(strstr(pcvt_last_error(), "limit") != NULL);
    pcvt_free(result);
}

static void the_floating_point_environment_of_the_host_stays_and_does_not_matter(void) {
    pcvt_options options = options_for(50);
    pcvt_sites nearest, upward;
    watch seen = {0, 0};
    options.progress = cancel_at_7;
    options.progress_data = &seen;
    options.max_iterations = 5;
    pcvt_result *first = NULL, *second = NULL;
    CHECK(pcvt_generate(&options, &first) == PCVT_NOT_CONVERGED);
    fesetround(FE_UPWARD);
    feclearexcept(FE_ALL_EXCEPT);
    const pcvt_status status = pcvt_generate(&options, &second);
    CHECK(fetestexcept(FE_ALL_EXCEPT) == 0 && fegetround() == FE_UPWARD);
    fesetround(FE_TONEAREST);
    CHECK(status == PCVT_NOT_CONVERGED && seen.rounding == FE_UPWARD);
    CHECK(pcvt_get_sites(first, &nearest, sizeof nearest) == PCVT_OK);
    CHECK(pcvt_get_sites(second, &upward, sizeof upward) == PCVT_OK);
    CHECK(memcmp(nearest.points, upward.points, 100 * sizeof(double)) == 0);
    pcvt_free(first);
    pcvt_free(second);
}

static void sizes_and_versions_that_do_not_fit_are_refused(void) {
    pcvt_options options = options_for(10);
    const size_t size = sizeof options;
    CHECK(pcvt_abi_version() == PCVT_ABI_VERSION);
    CHECK(pcvt_options_init(&options, size, PCVT_ABI_VERSION + 1) == PCVT_ERROR_ABI);
    CHECK(pcvt_options_init(&options, size, PCVT_ABI_VERSION + 0x10000) == PCVT_ERROR_ABI);
    CHECK(pcvt_options_init(&options, size - 1, PCVT_ABI_VERSION) == PCVT_ERROR_ABI);
    CHECK(pcvt_options_init(&options, (size_t)-1, PCVT_ABI_VERSION) == PCVT_ERROR_ABI);
    CHECK(options.struct_size == size);
    options.struct_size = 0;
    REFUSED(&options, PCVT_ERROR_ABI, "size 0");
    options.struct_size = size - 8;
    REFUSED(&options, PCVT_ERROR_ABI, "size");
    options.struct_size = (size_t)1 << 40;
    REFUSED(&options, PCVT_ERROR_ABI, "size");
}

static void the_interface_has_the_version_of_the_library(void) {
    char version[32];
    snprintf(version, sizeof version, "%u.%u.", (unsigned)(PCVT_ABI_VERSION >> 16),
             (unsigned)(PCVT_ABI_VERSION & 0xFFFF));
    CHECK(strncmp(pcvt_version(), version, strlen(version)) == 0);
}

static void a_longer_struct_is_taken_where_its_tail_is_zero(void) {
    struct newer_options {
        pcvt_options known;
        double unknown;
    } newer;
    memset(&newer, 0xFF, sizeof newer);
    CHECK(pcvt_options_init(&newer.known, sizeof newer, PCVT_ABI_VERSION) == PCVT_OK);
    CHECK(newer.unknown == 0 && newer.known.struct_size == sizeof newer);
    newer.known.n_sites = 10;
    pcvt_free(generated(&newer.known));
    newer.unknown = 1;
    REFUSED(&newer.known, PCVT_ERROR_ABI, "does not know");
}

static void views_come_in_the_size_of_the_host(void) {
    struct newer_view {
        pcvt_sites known;
        double unknown;
    } newer;
    pcvt_options options = options_for(10);
    pcvt_result* result = generated(&options);
    newer.unknown = 7;
    CHECK(pcvt_get_sites(result, &newer.known, sizeof newer) == PCVT_OK);
    CHECK(newer.known.n_sites == 10 && newer.unknown == 0);
    CHECK(pcvt_get_sites(result, &newer.known, sizeof newer.known - 1) == PCVT_ERROR_ABI);
    pcvt_free(result);
}

static void null_pointers_are_refused(void) {
    pcvt_options options = options_for(10);
    pcvt_result* result = generated(&options);
    pcvt_sites sites;
    CHECK(pcvt_options_init(NULL, sizeof options, PCVT_ABI_VERSION) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_generate(&options, NULL) == PCVT_ERROR_ARGUMENT);
    REFUSED(NULL, PCVT_ERROR_ARGUMENT, "null");
    CHECK(pcvt_get_sites(NULL, &sites, sizeof sites) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_sites(result, NULL, sizeof sites) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_statistics(result, NULL, 0) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_mesh(result, PCVT_VORONOI, NULL, 0) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_tile(result, PCVT_VORONOI, PCVT_WHOLE, NULL, 0) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_write(NULL, "t.obj", NULL) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_write(result, NULL, NULL) == PCVT_ERROR_ARGUMENT);
    pcvt_free(NULL);
    pcvt_free(result);
}

static void numbers_that_are_not_finite_are_refused(void) {
    const double sites[4] = {0.1, 0.2, 0.6, (double)NAN};
    pcvt_options options = options_for(2);
    options.sites = sites;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "site 1");
    options = options_for(2);
    options.lattice[3] = (double)NAN;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "lattice");
    options = options_for(2);
    options.origin[1] = (double)INFINITY;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "origin");
    options = options_for(2);
    options.tolerance = (double)NAN;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "tolerance");
}

static void values_out_of_range_are_refused(void) {
    pcvt_options options = options_for(0);
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "n_sites");
    options = options_for(2);
    options.n_threads = -1;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "n_threads");
    options = options_for(2);
    options.rows = 0;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "repetition");
    options = options_for(2);
    options.solver = 77;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "solver 77");
    options = options_for(2);
    options.start = -1;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "start -1");
    options = options_for(2);
    options.lattice[2] = 1, options.lattice[3] = 0;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "parallel");
    options = options_for(1 << 28);
    options.columns = 1 << 20;
    REFUSED(&options, PCVT_ERROR_MEMORY, "cells");
}

static void unknown_tiles_are_refused(void) {
    pcvt_options options = options_for(5);
    pcvt_result* result = generated(&options);
    pcvt_tile tile;
    pcvt_mesh mesh;
    CHECK(pcvt_get_tile(result, 9, PCVT_WHOLE, &tile, sizeof tile) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_tile(result, PCVT_VORONOI, -1, &tile, sizeof tile) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_mesh(result, PCVT_GRAINS, &mesh, sizeof mesh) == PCVT_ERROR_ARGUMENT);
    pcvt_free(result);
}

static void coincident_sites_are_named(void) {
    const double sites[6] = {0.25, 0.5, 0.5, 0.5, 1.25, -0.5};
    pcvt_options options = options_for(3);
    options.sites = sites;
    REFUSED(&options, PCVT_ERROR_GEOMETRY, "sites 0 and 2");
}

static int always_nan(const double* points, size_t n_points, double* values, void* data) {
    (void)points, (void)data;
    for (size_t k = 0; k < n_points; ++k) values[k] = (double)NAN;
    return 0;
}

static int unwilling(const double* points, size_t n_points, double* values, void* data) {
    (void)points, (void)n_points, (void)values, (void)data;
    return 9;
}

static int ridge(const double* points, size_t n_points, double* values, void* data) {
    *(int*)data = fegetround();
    for (size_t k = 0; k < n_points; ++k) {
        values[k] = 1 + 3 * (points[2 * k] > 0.25 && points[2 * k] < 0.75);
    }
    return 0;
}

static void a_density_that_misbehaves_is_outside_of_the_domain(void) {
    pcvt_options options = options_for(20);
    options.density = always_nan;
    REFUSED(&options, PCVT_ERROR_DOMAIN, "density");
    options.density = unwilling;
    REFUSED(&options, PCVT_ERROR_DOMAIN, "returned 9");
    options.density_source = "1 + u";
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "density_source");
    options.density = NULL;
    options.density_source = "1 + ";
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "character");
    options.density_source = "-1";
    REFUSED(&options, PCVT_ERROR_DOMAIN, "density");
}

static void a_density_grades_the_cells(void) {
    pcvt_options options = options_for(100);
    pcvt_result* result = NULL;
    pcvt_sites sites;
    pcvt_statistics figures;
    int rounding = -1, n_inside = 0;
    options.density = ridge;
    options.density_data = &rounding;
    options.tolerance = 1e-3;
    CHECK(pcvt_generate(&options, &result) >= 0 && rounding == FE_TONEAREST);
    CHECK(pcvt_get_sites(result, &sites, sizeof sites) == PCVT_OK);
    CHECK(pcvt_get_statistics(result, &figures, sizeof figures) == PCVT_OK);
    CHECK(isnan(figures.energy_bound) && figures.n_threads == 1);
    for (int k = 0; k < 100; ++k) {
        n_inside += sites.points[2 * k] > 0.25 && sites.points[2 * k] < 0.75;
    }
    CHECK(n_inside > 60 && n_inside < 73); /* two thirds: as the square root of the density */
    pcvt_free(result);
}

static void files_are_written_once_unless_replaced(void) {
    pcvt_options options = options_for(20);
    pcvt_write_options how = {0};
    pcvt_result* result = generated(&options);
    how.struct_size = sizeof how;
    how.kind = PCVT_DELAUNAY;
    how.replace = 1;
    CHECK(pcvt_write(result, "pcvt_test.ply", &how) == PCVT_OK);
    how.replace = 0;
    CHECK(pcvt_write(result, "pcvt_test.ply", &how) == PCVT_ERROR_IO);
    CHECK(strstr(pcvt_last_error(), "exists") && !strstr(pcvt_last_error(), "--"));
    CHECK(pcvt_write(result, "no/such/folder.ply", NULL) == PCVT_ERROR_IO);
    CHECK(pcvt_write(result, "pcvt_test.xyz", NULL) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_write(result, "", NULL) == PCVT_ERROR_ARGUMENT);
    how.struct_size = 8;
    CHECK(pcvt_write(result, "pcvt_test.ply", &how) == PCVT_ERROR_ABI);
    CHECK(remove("pcvt_test.ply") == 0);
    pcvt_free(result);
}

static void every_status_has_a_text_of_its_own(void) {
    for (pcvt_status s = PCVT_ERROR_INTERNAL - 1; s <= PCVT_NOT_CONVERGED; ++s) {
        CHECK(strlen(pcvt_status_text(s)) > 3);
        for (pcvt_status t = s + 1; t <= PCVT_NOT_CONVERGED; ++t) {
            CHECK(strcmp(pcvt_status_text(s), pcvt_status_text(t)) != 0);
        }
    }
}

int main(void) {
    every_identified_edge_pair_is_a_translation();
    meshes_on_the_torus_are_closed();
    statistics_tell_the_run();
    results_do_not_depend_on_threads_or_on_where_sites_come_from();
    cancelling_at_iteration_7_gives_the_cancelled_status();
    the_iteration_limit_gives_a_result_that_is_not_converged();
    the_floating_point_environment_of_the_host_stays_and_does_not_matter();
    sizes_and_versions_that_do_not_fit_are_refused();
    the_interface_has_the_version_of_the_library();
    a_longer_struct_is_taken_where_its_tail_is_zero();
    views_come_in_the_size_of_the_host();
    null_pointers_are_refused();
    numbers_that_are_not_finite_are_refused();
    values_out_of_range_are_refused();
    unknown_tiles_are_refused();
    coincident_sites_are_named();
    a_density_that_misbehaves_is_outside_of_the_domain();
    a_density_grades_the_cells();
    files_are_written_once_unless_replaced();
    every_status_has_a_text_of_its_own();
    printf("%d claims failed\n", n_failed);
    return n_failed != 0;
}
