/* The C interface seen by a C99 host: results, their seams and their files. */
#include <float.h>
#include <math.h>

#include "tests/support/claims.h"

/* Returns the distance of position(w) from position(v) + i a + j b, in units of the last place. */
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

/* Returns the number of edges that have no face on their other side. */
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

static void statistics_describe_the_run(void) {
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

static void results_do_not_depend_on_threads_or_on_the_source_of_the_sites(void) {
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

static void existing_files_are_kept_unless_replaced(void) {
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
    CHECK(pcvt_write(result, "/dev/null/folder.ply", NULL) == PCVT_ERROR_IO);
    CHECK(pcvt_write(result, "pcvt_test.xyz", NULL) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_write(result, "", NULL) == PCVT_ERROR_ARGUMENT);
    how.struct_size = 8;
    CHECK(pcvt_write(result, "pcvt_test.ply", &how) == PCVT_ERROR_ABI);
    CHECK(remove("pcvt_test.ply") == 0);
    pcvt_free(result);
}

int main(void) {
    every_identified_edge_pair_is_a_translation();
    meshes_on_the_torus_are_closed();
    statistics_describe_the_run();
    results_do_not_depend_on_threads_or_on_the_source_of_the_sites();
    existing_files_are_kept_unless_replaced();
    return end_of_claims();
}
