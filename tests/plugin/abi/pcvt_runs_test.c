/* Runs seen by a C99 host: how they end and how they call its callbacks. */
#include <fenv.h>
#include <math.h>
#include <string.h>

#include "tests/support/claims.h"

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

static void the_floating_point_environment_of_the_host_is_kept_and_does_not_matter(void) {
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

static void cells_have_phases_and_orientations(void) {
    const double angles[12] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    const double weights[4] = {0, 0.5, 0, 1.5};
    pcvt_options options = options_for(4);
    pcvt_result* result = NULL;
    pcvt_sites sites;
    int32_t s, first = 0;
    options.phases = "soft:0.25,hard:0.75";
    options.orientations = angles;
    options.n_orientations = 4;
    CHECK(pcvt_generate(&options, &result) == PCVT_OK);
    CHECK(pcvt_get_sites(result, &sites, sizeof sites) == PCVT_OK);
    CHECK(sites.n_phases == 2);
    CHECK(strcmp(sites.phase_names[0], "soft") == 0 && strcmp(sites.phase_names[1], "hard") == 0);
    for (s = 0; s < 4; ++s) first += sites.phases[s] == 0;
    CHECK(first == 1);
    for (s = 0; s < 12; ++s) CHECK(sites.orientations[s] == angles[s]);
    pcvt_free(result);
    /* A list with weights. */
    options.orientation_weights = weights;
    CHECK(pcvt_generate(&options, &result) == PCVT_OK);
    CHECK(pcvt_get_sites(result, &sites, sizeof sites) == PCVT_OK);
    first = 0;
    for (s = 0; s < 4; ++s) {
        CHECK(sites.orientations[3 * s] == 4 || sites.orientations[3 * s] == 10);
        first += sites.orientations[3 * s] == 4;
    }
    CHECK(first == 1);
    pcvt_free(result);
    options = options_for(4);
    CHECK(pcvt_generate(&options, &result) == PCVT_OK);
    CHECK(pcvt_get_sites(result, &sites, sizeof sites) == PCVT_OK);
    CHECK(sites.phases == NULL && sites.phase_names == NULL && sites.orientations == NULL);
    CHECK(sites.n_phases == 0);
    pcvt_free(result);
}

static void inclusions_are_those_that_were_given(void) {
    const double numbers[14] = {0.5, 0.9, 0.1, 0.5, 0.4, 0.2, 0.1,
                                30,  0.1, 0.1, 0.3, 0.1, 0.2, 0.3};
    pcvt_options options = options_for(500);
    pcvt_result* result = NULL;
    pcvt_inclusions shapes;
    int32_t k;
    options.inclusions =
        "circle a 0.5 0.9 0.1\nellipse b 0.5 0.4 0.2 0.1 30\ncircle a 1.5 -0.1 0.1\n"
        "polygon a .1 .1 .3 .1 .2 .3\nellipse b 0.5 1.4 0.2 0.1 210";
    options.tolerance = 1e-2;
    CHECK(pcvt_generate(&options, &result) == PCVT_OK);
    CHECK(pcvt_get_inclusions(result, &shapes, sizeof shapes) == PCVT_OK);
    CHECK(shapes.n_shapes == 3);
    CHECK(shapes.begin[0] == 0 && shapes.begin[1] == 3 && shapes.begin[2] == 8);
    CHECK(shapes.begin[3] == 14);
    CHECK(shapes.form[0] == PCVT_CIRCLE && shapes.form[1] == PCVT_ELLIPSE);
    CHECK(shapes.form[2] == PCVT_POLYGON);
    CHECK(strcmp(shapes.tags[0], "a") == 0 && strcmp(shapes.tags[1], "b") == 0);
    CHECK(strcmp(shapes.tags[2], "a") == 0);
    for (k = 0; k < 14; ++k) CHECK(shapes.numbers[k] == numbers[k]);
    pcvt_free(result);
    options = options_for(4);
    CHECK(pcvt_generate(&options, &result) == PCVT_OK);
    CHECK(pcvt_get_inclusions(result, &shapes, sizeof shapes) == PCVT_OK);
    CHECK(shapes.n_shapes == 0 && shapes.numbers == NULL && shapes.begin == NULL);
    CHECK(pcvt_get_inclusions(NULL, &shapes, sizeof shapes) == PCVT_ERROR_ARGUMENT);
    pcvt_free(result);
}

static void tiles_with_holes_know_their_edges(void) {
    pcvt_options options = options_for(300);
    pcvt_result* result = NULL;
    pcvt_tile tile;
    pcvt_mesh mesh;
    pcvt_sites sites;
    int32_t k, n_at_holes = 0;
    options.inclusions = "circle core 0.1 0.9 0.15\ncircle pipe 0.5 0.4 0.2\n";
    options.holes = "pipe,core";
    result = generated(&options);
    CHECK(pcvt_get_tile(result, PCVT_VORONOI, PCVT_WHOLE, &tile, sizeof tile) == PCVT_OK);
    CHECK(pcvt_get_sites(result, &sites, sizeof sites) == PCVT_OK);
    CHECK(tile.n_faces == sites.n_sites && sites.n_sites < 300);
    CHECK(sites.n_phases == 1 && strcmp(sites.phase_names[0], "matrix") == 0);
    CHECK(tile.n_holes == 2 && tile.n_wall_edges > 10);
    CHECK(strcmp(tile.hole_names[0], "pipe") == 0 && strcmp(tile.hole_names[1], "core") == 0);
    for (k = 0; k < tile.n_wall_edges; ++k) {
        const int32_t hole = tile.wall_edges[k].wall - PCVT_WALL_HOLE;
        CHECK(hole == 0 || hole == 1);
    }
    CHECK(pcvt_get_mesh(result, PCVT_VORONOI, &mesh, sizeof mesh) == PCVT_OK);
    CHECK(mesh.n_faces == sites.n_sites);
    for (k = 0; k < mesh.n_corners; ++k) n_at_holes += mesh.opposite[k] < 0;
    CHECK(n_at_holes == tile.n_wall_edges);
    pcvt_free(result);
}

static void tiles_between_walls_know_their_edges(void) {
    pcvt_options options = options_for(40);
    pcvt_result* result = NULL;
    pcvt_tile tile;
    pcvt_mesh mesh;
    int32_t k, n_on_walls = 0;
    options.walls = PCVT_WALLS_Y;
    result = generated(&options);
    CHECK(pcvt_get_tile(result, PCVT_VORONOI, PCVT_WHOLE, &tile, sizeof tile) == PCVT_OK);
    CHECK(tile.n_faces == 40 && tile.n_wall_edges > 2);
    for (k = 0; k < tile.n_wall_edges; ++k) {
        const pcvt_wall_edge edge = tile.wall_edges[k];
        const double y = edge.wall == PCVT_WALL_TOP ? tile.lattice[3] : 0;
        CHECK(edge.wall == PCVT_WALL_BOTTOM || edge.wall == PCVT_WALL_TOP);
        CHECK(tile.points[2 * edge.v0 + 1] == y && tile.points[2 * edge.v1 + 1] == y);
        /* The tile is on the left: edges at the bottom run to the right. */
        CHECK((tile.points[2 * edge.v0] < tile.points[2 * edge.v1]) ==
              (edge.wall == PCVT_WALL_BOTTOM));
    }
    CHECK(pcvt_get_mesh(result, PCVT_VORONOI, &mesh, sizeof mesh) == PCVT_OK);
    CHECK(mesh.n_faces == 40);
    for (k = 0; k < mesh.n_corners; ++k) n_on_walls += mesh.opposite[k] < 0;
    CHECK(n_on_walls == tile.n_wall_edges);
    /* Triangles of whole cells would cross the walls. */
    CHECK(pcvt_get_mesh(result, PCVT_DELAUNAY, &mesh, sizeof mesh) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_tile(result, PCVT_DELAUNAY, PCVT_WHOLE, &tile, sizeof tile) ==
          PCVT_ERROR_ARGUMENT);
    pcvt_free(result);
    options.wall_cells = PCVT_WALL_CELLS_HALF;
    result = generated(&options);
    CHECK(pcvt_get_tile(result, PCVT_DELAUNAY, PCVT_WHOLE, &tile, sizeof tile) == PCVT_OK);
    CHECK(tile.n_wall_edges > 2);
    pcvt_free(result);
    options.walls = PCVT_WALLS_NONE;
    options.wall_cells = PCVT_WALL_CELLS_WHOLE;
    result = generated(&options);
    CHECK(pcvt_get_tile(result, PCVT_VORONOI, PCVT_WHOLE, &tile, sizeof tile) == PCVT_OK);
    CHECK(tile.n_wall_edges == 0 && tile.wall_edges == NULL);
    pcvt_free(result);
}

static void sites_of_a_symmetry_have_orbits(void) {
    pcvt_options options = options_for(10);
    pcvt_result* result = NULL;
    pcvt_sites sites;
    int32_t s, n_orbits = 0, n_of_first = 0;
    options.symmetry = PCVT_SYMMETRY_P4;
    result = generated(&options);
    CHECK(pcvt_get_sites(result, &sites, sizeof sites) == PCVT_OK);
    /* Two orbits of four sites, and a centre each. */
    CHECK(sites.n_orbits == 4);
    for (s = 0; s < 10; ++s) {
        CHECK(sites.orbits[s] <= n_orbits);
        if (sites.orbits[s] == n_orbits) ++n_orbits;
        n_of_first += sites.orbits[s] == 0;
    }
    CHECK(n_orbits == 4 && (n_of_first == 1 || n_of_first == 4));
    pcvt_free(result);
    options.symmetry = PCVT_SYMMETRY_NONE;
    result = generated(&options);
    CHECK(pcvt_get_sites(result, &sites, sizeof sites) == PCVT_OK);
    CHECK(sites.n_orbits == 0 && sites.orbits == NULL);
    pcvt_free(result);
}

static void cells_of_given_areas_have_weights(void) {
    const double areas[4] = {1, 2, 3, 4};
    pcvt_options options = options_for(4);
    pcvt_result* result = NULL;
    pcvt_sites sites;
    pcvt_statistics figures;
    pcvt_tile tile;
    int32_t f, k;
    options.areas = areas;
    options.n_areas = 4;
    options.max_iterations = 3;
    options.aspect = 2;
    /* The cells have their areas, but the sites are not yet at the centroids. */
    CHECK(pcvt_generate(&options, &result) == PCVT_NOT_CONVERGED);
    CHECK(pcvt_get_sites(result, &sites, sizeof sites) == PCVT_OK);
    CHECK(pcvt_get_statistics(result, &figures, sizeof figures) == PCVT_OK);
    CHECK(pcvt_get_tile(result, PCVT_VORONOI, PCVT_WHOLE, &tile, sizeof tile) == PCVT_OK);
    CHECK(sites.weights[3] > sites.weights[0]);
    CHECK(figures.area_error < 1e-10 && figures.newton_steps > 0);
    for (f = 0; f < 4; ++f) {
        double area = 0;
        for (k = tile.face_begin[f]; k < tile.face_begin[f + 1]; ++k) {
            const int32_t next = k + 1 < tile.face_begin[f + 1] ? k + 1 : tile.face_begin[f];
            const double* p = tile.points + 2 * tile.corners[k];
            const double* q = tile.points + 2 * tile.corners[next];
            area += (p[0] * q[1] - q[0] * p[1]) / 2;
        }
        CHECK(fabs(area - areas[tile.face_site[f]] / 10) < 1e-8);
    }
    pcvt_free(result);
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

static void an_invalid_density_is_a_domain_error(void) {
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
    CHECK(n_inside > 60 && n_inside < 73); /* two thirds: density^(1/2) */
    pcvt_free(result);
}

int main(void) {
    cancelling_at_iteration_7_gives_the_cancelled_status();
    the_iteration_limit_gives_a_result_that_is_not_converged();
    the_floating_point_environment_of_the_host_is_kept_and_does_not_matter();
    cells_of_given_areas_have_weights();
    cells_have_phases_and_orientations();
    inclusions_are_those_that_were_given();
    sites_of_a_symmetry_have_orbits();
    tiles_between_walls_know_their_edges();
    tiles_with_holes_know_their_edges();
    an_invalid_density_is_a_domain_error();
    a_density_grades_the_cells();
    return end_of_claims();
}
