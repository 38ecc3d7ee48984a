/* The C interface in three dimensions seen by a C99 host: cells, their seam, runs and files. */
#include <fenv.h>
#include <float.h>
#include <math.h>

#include "tests/support/space_claims.h"

static const double oblique[9] = {1, 0, 0, 0.37, 0.81, 0, 0.2, 0.4, 0.9};
static const double left_handed[9] = {1, 0, 0, 0, 0, 1.1, 0.3, 0.8, 0};

static double determinant(const double* m) {
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
           m[2] * (m[3] * m[7] - m[4] * m[6]);
}

/* Returns the distance of q from p + i a + j b + k c, in units of the last place of the tile. */
static double misfit(const pcvt_cells* cells, const double* p, const double* q,
                     const int32_t* offset) {
    double largest = 0, worst = 0;
    for (int32_t k = 0; k < 3 * cells->n_points; ++k) {
        largest = fmax(largest, fabs(cells->points[k]));
    }
    for (int x = 0; x < 3; ++x) {
        const double there = p[x] + offset[0] * cells->lattice[x] +
                             offset[1] * cells->lattice[3 + x] + offset[2] * cells->lattice[6 + x];
        worst = fmax(worst, fabs(q[x] - there));
    }
    return worst / (DBL_EPSILON * largest);
}

static const double* face_point(const pcvt_cells* cells, int32_t face, int32_t k) {
    return &cells->points[3 * cells->face_points[cells->face_begin[face] + k]];
}

static int32_t n_corners(const pcvt_cells* cells, int32_t face) {
    return cells->face_begin[face + 1] - cells->face_begin[face];
}

static void check_seam(const pcvt_cells* cells) {
    const int32_t n_boundary = cells->n_faces - cells->n_inner_faces;
    CHECK(n_boundary > 0 && n_boundary % 2 == 0);
    for (int32_t b = 0; b < n_boundary; ++b) {
        const int32_t f = cells->n_inner_faces + b, g = cells->partner[b];
        const int32_t* offset = &cells->partner_offset[3 * b];
        CHECK(g >= cells->n_inner_faces && g < cells->n_faces && g != f);
        CHECK(offset[0] != 0 || offset[1] != 0 || offset[2] != 0);
        const int32_t back = g - cells->n_inner_faces, n = n_corners(cells, f);
        CHECK(cells->partner[back] == f && n_corners(cells, g) == n);
        for (int x = 0; x < 3; ++x) CHECK(cells->partner_offset[3 * back + x] == -offset[x]);
        for (int32_t k = 0; k < n; ++k) {
            const double* from = face_point(cells, f, (n - k) % n);
            CHECK(misfit(cells, from, face_point(cells, g, k), offset) < 4);
        }
    }
    for (int32_t p = 0; p < cells->n_points; ++p) {
        const int32_t orbit = cells->point_orbit[p];
        CHECK(orbit <= p && cells->point_orbit[orbit] == orbit);
        CHECK(misfit(cells, &cells->points[3 * orbit], &cells->points[3 * p],
                     &cells->point_offset[3 * p]) < 4);
    }
}

/* Returns the volume between a face and the origin, positive if its points are counter-clockwise
 * seen from the far side: a third of its area vector times its centre, both by triangles from the
 * mean of its corners, as finite-volume solvers take them. */
static double cone(const pcvt_cells* cells, int32_t face) {
    const int32_t n = n_corners(cells, face);
    double mean[3] = {0, 0, 0}, area[3] = {0, 0, 0}, centre[3] = {0, 0, 0}, sum = 0;
    for (int32_t k = 0; k < n; ++k)
        for (int x = 0; x < 3; ++x) mean[x] += face_point(cells, face, k)[x] / n;
    for (int32_t k = 0; k < n; ++k) {
        const double* p = face_point(cells, face, k);
        const double* q = face_point(cells, face, (k + 1) % n);
        double triangle[3], size = 0;
        for (int x = 0; x < 3; ++x) {
            const int y = (x + 1) % 3, z = (x + 2) % 3;
            triangle[x] = ((q[y] - p[y]) * (mean[z] - p[z]) - (q[z] - p[z]) * (mean[y] - p[y])) / 2;
            area[x] += triangle[x];
            size += triangle[x] * triangle[x];
        }
        size = sqrt(size);
        sum += size;
        for (int x = 0; x < 3; ++x) centre[x] += size * (p[x] + q[x] + mean[x]) / 3;
    }
    return (area[0] * centre[0] + area[1] * centre[1] + area[2] * centre[2]) / (3 * sum);
}

/* The volumes follow from owners, neighbours and the order of the points of each face. */
static void check_volumes(const pcvt_cells* cells, double volume) {
    double sum = 0;
    for (int32_t f = 0; f < cells->n_faces; ++f) {
        const int is_inner = f < cells->n_inner_faces;
        CHECK(cells->owner[f] >= 0 && cells->owner[f] < cells->n_cells);
        CHECK(is_inner ? cells->neighbour[f] > cells->owner[f] : cells->neighbour[f] == -1);
        CHECK(cells->neighbour[f] < cells->n_cells);
    }
    for (int32_t s = 0; s < cells->n_cells; ++s) {
        double own = 0;
        for (int32_t f = 0; f < cells->n_faces; ++f) {
            if (cells->owner[f] == s) own += cone(cells, f);
            if (cells->neighbour[f] == s) own -= cone(cells, f);
        }
        CHECK(cells->volumes[s] > 0 && fabs(own - cells->volumes[s]) < 1e-12);
        sum += cells->volumes[s];
    }
    CHECK(fabs(sum - volume) < 1e-12 * volume);
}

/* The two images of each site differ by a translation of the lattice. */
static void check_sites(const pcvt_cells* cells) {
    const double* m = cells->lattice;
    const int is_cube = m[0] == 1 && m[4] == 1 && m[8] == 1;
    for (int32_t s = 0; s < cells->n_cells; ++s) {
        double solve[9], move[3];
        for (int x = 0; x < 3; ++x) {
            const double wrapped = cells->sites[3 * s + x];
            move[x] = cells->site_points[3 * s + x] - wrapped;
            CHECK(!is_cube || (wrapped >= 0 && wrapped < 1));
        }
        for (int k = 0; k < 3; ++k) {
            memcpy(solve, m, sizeof solve);
            memcpy(&solve[3 * k], move, sizeof move);
            const double steps = determinant(solve) / determinant(m);
            CHECK(fabs(steps - round(steps)) < 1e-12 && fabs(steps) < 3);
        }
    }
}

static void each_boundary_face_has_a_partner_by_a_translation(void) {
    const double* lattices[3] = {NULL, oblique, left_handed};
    for (int k = 0; k < 3; ++k) {
        for (int32_t n = 1; n <= 40; n += 13) {
            pcvt_options options = space_options_for(n);
            if (lattices[k] != NULL) memcpy(options.lattice3, lattices[k], sizeof oblique);
            options.seed = 3;
            pcvt_result* result = generated(&options);
            const pcvt_cells cells = cells_of(result);
            CHECK(cells.n_cells == n && cells.face_begin[cells.n_faces] == cells.n_face_points);
            CHECK(memcmp(cells.lattice, options.lattice3, sizeof cells.lattice) == 0);
            check_seam(&cells);
            check_volumes(&cells, fabs(determinant(options.lattice3)));
            check_sites(&cells);
            pcvt_free(result);
        }
    }
}

static void short_edges_are_removed(void) {
    pcvt_options options = space_options_for(60);
    options.max_iterations = 0;
    pcvt_result* plain = generated(&options);
    options.short_edges = 0.05;
    pcvt_result* smooth = generated(&options);
    const pcvt_cells before = cells_of(plain), after = cells_of(smooth);
    CHECK(after.n_cells == 60 && after.n_face_points < before.n_face_points - 60);
    check_seam(&after);
    check_volumes(&after, 1);
    pcvt_free(plain);
    pcvt_free(smooth);
    pcvt_result* result = NULL;
    options.short_edges = 0.2;
    CHECK(pcvt_generate(&options, &result) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "not between 0 and 0.1 h") != NULL);
}

static void body_centred_lattices_have_the_energy_of_truncated_octahedra(void) {
    const int32_t numbers[3] = {2, 16, 54};
    for (int k = 0; k < 3; ++k) {
        for (int side = 1; side <= 2; ++side) {
            const double volume = side * side * side;
            const double energy =
                19 / (192 * cbrt(2)) * 3 * pow(volume, 5.0 / 3) * pow(numbers[k], -2.0 / 3);
            pcvt_options options = space_options_for(numbers[k]);
            pcvt_statistics figures;
            for (int d = 0; d < 9; d += 4) options.lattice3[d] = side;
            options.start = PCVT_START_LATTICE;
            pcvt_result* result = generated(&options);
            CHECK(pcvt_get_statistics(result, &figures, sizeof figures) == PCVT_OK);
            CHECK(fabs(figures.energy - energy) < 1e-12 * energy);
            CHECK(fabs(figures.energy_bound - energy) < 1e-12 * energy);
            CHECK(figures.stop == PCVT_STOP_CONVERGED && figures.n_sites == numbers[k]);
            CHECK(figures.n_valences == 15 && figures.valences[14] == numbers[k]);
            CHECK(figures.n_hexagons == 0 && figures.n_mirrors == -1);
            CHECK(isnan(figures.area_error) && figures.evaluations >= 1);
            pcvt_free(result);
        }
    }
}

static int32_t minimum_of(const pcvt_result* result) {
    int32_t minimum = -1;
    CHECK(pcvt_get_minimum(result, &minimum) == PCVT_OK);
    return minimum;
}

static void minima_and_saddles_are_known(void) {
    double grid[24];
    for (int k = 0; k < 24; ++k) grid[k] = (k / 3 >> k % 3 & 1) / 2.0;
    pcvt_options options = space_options_for(16);
    options.start = PCVT_START_LATTICE;
    pcvt_result* octahedra = generated(&options);
    CHECK(minimum_of(octahedra) == PCVT_MINIMUM_YES);
    CHECK(minimum_of(octahedra) == PCVT_MINIMUM_YES);
    pcvt_free(octahedra);
    options = space_options_for(8);
    options.sites = grid;
    pcvt_result* cubes = generated(&options);
    CHECK(minimum_of(cubes) == PCVT_MINIMUM_NO);
    pcvt_free(cubes);
    options = space_options_for(40);
    options.max_iterations = 0;
    pcvt_result* unfinished = generated(&options);
    CHECK(minimum_of(unfinished) == PCVT_MINIMUM_UNKNOWN);
    pcvt_free(unfinished);
}

static void statistics_describe_the_run(void) {
    pcvt_options options = space_options_for(60);
    pcvt_statistics figures;
    int32_t n_cells = 0, n_sides = 0;
    options.n_threads = 2;
    pcvt_result* result = generated(&options);
    CHECK(pcvt_get_statistics(result, &figures, sizeof figures) == PCVT_OK);
    CHECK(figures.residual <= 1e-6 && figures.rms_residual <= figures.residual);
    CHECK(figures.energy > figures.energy_bound && figures.energy < 1.05 * figures.energy_bound);
    CHECK(figures.iterations > 1 && figures.n_threads == 2 && figures.seconds_optimize > 0);
    for (int32_t k = 0; k < figures.n_valences; ++k) {
        n_cells += figures.valences[k];
        n_sides += k * figures.valences[k];
    }
    const pcvt_cells cells = cells_of(result);
    CHECK(n_cells == 60 && n_sides == cells.n_faces + cells.n_inner_faces);
    pcvt_free(result);
}

static void results_do_not_depend_on_threads(void) {
    pcvt_options options = space_options_for(3000);
    options.max_iterations = 5;
    options.n_threads = 1;
    pcvt_result *first = NULL, *second = NULL;
    CHECK(pcvt_generate(&options, &first) == PCVT_NOT_CONVERGED);
    CHECK(strstr(pcvt_last_error(), "limit") != NULL);
    options.n_threads = 3;
    CHECK(pcvt_generate(&options, &second) == PCVT_NOT_CONVERGED);
    const pcvt_cells one = cells_of(first), three = cells_of(second);
    CHECK(one.n_faces == three.n_faces && one.n_points == three.n_points);
    CHECK(memcmp(one.sites, three.sites, 9000 * sizeof(double)) == 0);
    CHECK(memcmp(one.points, three.points, 3 * sizeof(double) * one.n_points) == 0);
    CHECK(memcmp(one.face_points, three.face_points, sizeof(int32_t) * one.n_face_points) == 0);
    pcvt_free(first);
    pcvt_free(second);
}

static void given_sites_keep_their_order(void) {
    const double sites[9] = {0.1, 0.2, 0.3, 5.5, -0.25, 0.5, 0.75, 2.25, -1.5};
    const double wrapped[9] = {0.1, 0.2, 0.3, 0.5, 0.75, 0.5, 0.75, 0.25, 0.5};
    pcvt_options options = space_options_for(3);
    options.sites = sites;
    options.max_iterations = 0;
    pcvt_result* result = generated(&options);
    const pcvt_cells cells = cells_of(result);
    for (int k = 0; k < 9; ++k) CHECK(fabs(cells.sites[k] - wrapped[k]) < 1e-15);
    pcvt_free(result);
    /* Sites of cells whose centroids lie in the domain need not lie there. */
    options = space_options_for(300);
    options.max_iterations = 0;
    result = generated(&options);
    const pcvt_cells many = cells_of(result);
    check_sites(&many);
    CHECK(memcmp(many.sites, many.site_points, 900 * sizeof(double)) != 0);
    pcvt_free(result);
}

typedef struct watch {
    int n_calls;
    int rounding;
    int last_iteration;
    int iteration;
    double bound;
} watch;

static int cancel_at_last(const pcvt_progress* progress, void* data) {
    watch* seen = data;
    seen->rounding = fegetround();
    seen->iteration = progress->iteration;
    seen->bound = progress->energy_bound;
    ++seen->n_calls;
    return progress->iteration == seen->last_iteration;
}

static void a_run_is_cancelled_at_once_and_later(void) {
    for (int last = 0; last <= 5; last += 5) {
        pcvt_options options = space_options_for(500);
        watch seen = {0, 0, last, -1, 0};
        options.progress = cancel_at_last;
        options.progress_data = &seen;
        REFUSED(&options, PCVT_CANCELLED, "cancelled");
        CHECK(seen.n_calls > last && seen.iteration == last);
        CHECK(fabs(seen.bound - 19 / (64 * cbrt(2)) * pow(500, -2.0 / 3)) < 1e-12);
    }
}

static int cancel(const pcvt_progress* progress, void* data) {
    return progress->phase == *(int32_t*)data;
}

static void a_write_is_cancelled_in_any_phase(void) {
    for (int32_t phase = PCVT_PHASE_BUILD; phase <= PCVT_PHASE_WRITE; ++phase) {
        pcvt_options options = space_options_for(200);
        pcvt_write_options how = {0};
        options.max_iterations = 0;
        pcvt_result* result = generated(&options);
        how.struct_size = sizeof how;
        how.progress = cancel;
        how.progress_data = &phase;
        CHECK(pcvt_write(result, "pcvt_space_test_cancelled.vtu", &how) == PCVT_CANCELLED);
        CHECK(strstr(pcvt_last_error(), "cancelled") != NULL);
        CHECK(!removes_file("pcvt_space_test_cancelled.vtu"));
        CHECK(cells_of(result).n_cells == 200);
        pcvt_free(result);
    }
}

static void the_floating_point_environment_of_the_host_is_kept_and_does_not_matter(void) {
    pcvt_options options = space_options_for(50);
    watch seen = {0, 0, -1, -1, 0};
    options.progress = cancel_at_last;
    options.progress_data = &seen;
    options.max_iterations = 5;
    pcvt_result *first = NULL, *second = NULL;
    pcvt_cells upward;
    CHECK(pcvt_generate(&options, &first) == PCVT_NOT_CONVERGED);
    fesetround(FE_UPWARD);
    feclearexcept(FE_ALL_EXCEPT);
    const pcvt_status status = pcvt_generate(&options, &second);
    const pcvt_status viewed = pcvt_get_cells(second, &upward, sizeof upward);
    CHECK(fetestexcept(FE_ALL_EXCEPT) == 0 && fegetround() == FE_UPWARD);
    fesetround(FE_TONEAREST);
    CHECK(status == PCVT_NOT_CONVERGED && viewed == PCVT_OK && seen.rounding == FE_UPWARD);
    const pcvt_cells nearest = cells_of(first);
    CHECK(memcmp(nearest.sites, upward.sites, 150 * sizeof(double)) == 0);
    CHECK(memcmp(nearest.points, upward.points, 3 * sizeof(double) * nearest.n_points) == 0);
    pcvt_free(first);
    pcvt_free(second);
}

static void existing_files_are_kept_unless_replaced(void) {
    pcvt_options options = space_options_for(20);
    pcvt_write_options how = {0};
    pcvt_result* result = generated(&options);
    how.struct_size = sizeof how;
    how.replace = 1;
    CHECK(pcvt_write(result, "pcvt_space_test.vtu", &how) == PCVT_OK);
    CHECK(pcvt_write(result, "pcvt_space_test.vtu", NULL) == PCVT_ERROR_IO);
    CHECK(strstr(pcvt_last_error(), "exists") && !strstr(pcvt_last_error(), "--"));
    CHECK(pcvt_write(result, "/dev/null/folder.vtu", NULL) == PCVT_ERROR_IO);
    CHECK(remove("pcvt_space_test.vtu") == 0);
    pcvt_free(result);
}

int main(void) {
    each_boundary_face_has_a_partner_by_a_translation();
    short_edges_are_removed();
    body_centred_lattices_have_the_energy_of_truncated_octahedra();
    minima_and_saddles_are_known();
    statistics_describe_the_run();
    results_do_not_depend_on_threads();
    given_sites_keep_their_order();
    a_run_is_cancelled_at_once_and_later();
    a_write_is_cancelled_in_any_phase();
    the_floating_point_environment_of_the_host_is_kept_and_does_not_matter();
    existing_files_are_kept_unless_replaced();
    return end_of_claims();
}
