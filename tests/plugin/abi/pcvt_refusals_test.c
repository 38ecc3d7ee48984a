/* Calls of a C99 host that the C interface refuses, each with its documented status. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <sys/resource.h>

#include "tests/support/claims.h"
#include "tests/support/mapped_memory.h"

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
    options.struct_size = offsetof(pcvt_options, duplicates) - 8;
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

static void a_longer_struct_is_accepted_if_its_tail_is_zero(void) {
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

static void a_struct_without_the_last_fields_is_accepted(void) {
    pcvt_options options = options_for(10);
    pcvt_write_options how;
    pcvt_statistics figures;
    pcvt_result* result;
    memset(&options, 0xFF, sizeof options);
    CHECK(pcvt_options_init(&options, offsetof(pcvt_options, duplicates), PCVT_ABI_VERSION) ==
          PCVT_OK);
    CHECK(options.struct_size == offsetof(pcvt_options, duplicates) && options.duplicates == -1);
    options.n_sites = 10;
    result = generated(&options);
    memset(&figures, 0xFF, sizeof figures);
    CHECK(pcvt_get_statistics(result, &figures, offsetof(pcvt_statistics, dropped)) == PCVT_OK);
    CHECK(figures.n_dropped == 0 && figures.dropped != NULL);
    memset(&how, 0xFF, sizeof how);
    memset(&how, 0, offsetof(pcvt_write_options, materials));
    how.struct_size = offsetof(pcvt_write_options, materials);
    how.replace = 1;
    CHECK(pcvt_write(result, "older.obj", &how) == PCVT_OK);
    remove("older.obj");
    remove("older.mtl");
    remove("older.seam.json");
    --how.struct_size;
    CHECK(pcvt_write(result, "older.obj", &how) == PCVT_ERROR_ABI);
    pcvt_free(result);
}

static void reserved_fields_are_zero(void) {
    pcvt_options options = options_for(10);
    pcvt_write_options how;
    pcvt_result* result = generated(&options);
    memset(&how, 0, sizeof how);
    how.struct_size = sizeof how;
    how.reserved2 = 1;
    CHECK(pcvt_write(result, "reserved.obj", &how) == PCVT_ERROR_ABI);
    CHECK(strstr(pcvt_last_error(), "does not know") != NULL);
    pcvt_free(result);
    options.reserved = 1;
    REFUSED(&options, PCVT_ERROR_ABI, "does not know");
    options.reserved = 0;
    options.reserved2 = 1;
    REFUSED(&options, PCVT_ERROR_ABI, "does not know");
    options.reserved2 = 0;
    options.reserved3 = 1;
    REFUSED(&options, PCVT_ERROR_ABI, "does not know");
}

static void views_have_the_size_that_the_host_states(void) {
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
    int32_t minimum;
    CHECK(pcvt_options_init(NULL, sizeof options, PCVT_ABI_VERSION) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_generate(&options, NULL) == PCVT_ERROR_ARGUMENT);
    REFUSED(NULL, PCVT_ERROR_ARGUMENT, "null");
    CHECK(pcvt_get_sites(NULL, &sites, sizeof sites) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_sites(result, NULL, sizeof sites) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_statistics(result, NULL, 0) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_minimum(result, NULL) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_minimum(NULL, &minimum) == PCVT_ERROR_ARGUMENT);
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
    options.columns = 1 << 10;
    REFUSED(&options, PCVT_ERROR_MEMORY, "cells");
    options.columns = 1 << 20;
    REFUSED(&options, PCVT_ERROR_MEMORY, "more than 10000 periods in a row");
}

/* One field of pcvt_options at a time, with values that no run has. */
static void every_field_is_checked(void) {
#define FIELD_REFUSED(field, value, words)             \
    do {                                               \
        pcvt_options changed = options_for(3);         \
        changed.field = (value);                       \
        REFUSED(&changed, PCVT_ERROR_ARGUMENT, words); \
    } while (0)
    const double bad_lengths[] = {-1, (double)NAN, (double)INFINITY};
    double angles[9] = {0, 0, 0, 0, 0, 400, 0, 0, 0};
    double weights[3] = {0, -1, 0};
    pcvt_options options = options_for(3);
    size_t k;
    for (k = 0; k < 3; ++k) {
        FIELD_REFUSED(grain_size, bad_lengths[k], "grain_size");
        FIELD_REFUSED(tolerance, bad_lengths[k], "tolerance");
        FIELD_REFUSED(short_edges, bad_lengths[k], k == 0 ? "edges are removed" : "short_edges");
    }
    FIELD_REFUSED(lattice[0], 1e308, "");
    FIELD_REFUSED(origin[0], 1e300, "origin");
    FIELD_REFUSED(n_sites, -1, "n_sites");
    FIELD_REFUSED(n_sites, INT32_MAX, "n_sites");
    FIELD_REFUSED(start, 5, "start 5");
    FIELD_REFUSED(solver, -1, "solver -1");
    FIELD_REFUSED(tolerance, 0, "tolerance");
    FIELD_REFUSED(n_threads, 1025, "n_threads");
    FIELD_REFUSED(columns, -1, "repetition");
    FIELD_REFUSED(rows, INT32_MIN, "repetition");
    FIELD_REFUSED(grain_order, 3, "grain_order");
    FIELD_REFUSED(grain_order, -1, "grain_order");
    FIELD_REFUSED(grain_per_edge, -1, "grain_per_edge");
    FIELD_REFUSED(short_edges, 0.6, "0.5 h");
    FIELD_REFUSED(budget, 1, "budget");
    FIELD_REFUSED(budget, -1, "budget");
    FIELD_REFUSED(find_origin, 2, "find_origin");
    FIELD_REFUSED(find_origin, -1, "find_origin");
    FIELD_REFUSED(density_source, "", "character 1");
    FIELD_REFUSED(density_source, "1 + \a u", "character 5: a control character");
    FIELD_REFUSED(density_range[0], (double)NAN, "density_range");
    FIELD_REFUSED(density_range[1], 1, "density_range");
    FIELD_REFUSED(n_areas, 3, "n_areas");
    FIELD_REFUSED(area_law, "", "law");
    FIELD_REFUSED(area_law, "gamma:-1", "gamma:S");
    FIELD_REFUSED(area_law, "0.5*equal@1+0.4*equal@2", "sum to 0.9");
    FIELD_REFUSED(aspect, 0, "aspect");
    FIELD_REFUSED(aspect, (double)NAN, "aspect");
    FIELD_REFUSED(aspect_degrees, (double)INFINITY, "aspect_degrees");
    FIELD_REFUSED(phases, "", "NAME:FRACTION");
    FIELD_REFUSED(phases, "a:0.5", "make the sum 1");
    FIELD_REFUSED(n_orientations, 3, "n_orientations");
    FIELD_REFUSED(random_orientations, 2, "random_orientations");
    FIELD_REFUSED(symmetry, -1, "symmetry -1 is unknown");
    FIELD_REFUSED(symmetry, PCVT_SYMMETRY_P6M + 1, "symmetry 18 is unknown");
    FIELD_REFUSED(walls, PCVT_WALLS_XY + 1, "walls 4 is unknown");
    FIELD_REFUSED(wall_cells, 2, "wall_cells 2 is unknown");
    FIELD_REFUSED(wall_cells, PCVT_WALL_CELLS_HALF, "wall_cells half needs walls; add walls");
    FIELD_REFUSED(inclusions, "circle", "inclusions:1: a tag is missing");
    FIELD_REFUSED(fibres, "0.5", "write FRACTION,N");
    FIELD_REFUSED(holes, "fibre",
                  "holes removes cells inside inclusions; add inclusions or fibres");
    FIELD_REFUSED(n_fixed_sites, 1, "fixed_sites is a null pointer");
    options.orientations = angles;
    options.n_orientations = 2;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "n_orientations");
    options.n_orientations = 3;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "-360 to 360");
    options.random_orientations = 1;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "exclude each other");
    options.random_orientations = 0;
    angles[5] = 0;
    options.orientation_weights = weights;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "orientation_weights are not all from 0 to 1e150");
    weights[1] = 0;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "or all are 0");
    options.orientations = NULL;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "orientations is a null pointer; give all");
    options.n_orientations = 0;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "orientations is a null pointer; give all");
    options = options_for(3);
#undef FIELD_REFUSED
}

static void fields_that_contradict_each_other_are_refused(void) {
    const double site[2] = {0.5, 0.5};
    const double areas[3] = {1, -1, 1};
    pcvt_options options = options_for(3);
    options.grain_size = 0.1;
    options.grain_per_edge = 2;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "grain_size does not work with grain_per_edge");
    options = options_for(3);
    options.areas = areas;
    options.n_areas = 2;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "n_areas");
    options.n_areas = 3;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "area of site 1");
    options.area_law = "equal";
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "areas and area_law");
    options = options_for(3);
    options.area_law = "equal";
    options.density_source = "1 + u";
    REFUSED(&options, PCVT_ERROR_ARGUMENT,
            "areas does not work with density; leave one of them out");
    options = options_for(3);
    options.start = PCVT_START_BEST;
    options.budget = (int64_t)1 << 31;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "budget");
    options = options_for(1);
    options.sites = site;
    options.start = PCVT_START_RANDOM;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "start");
    options = options_for(3);
    options.density_source = "1 + x";
    options.density_range[0] = 1;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "range");
}

static void symmetries_that_do_not_fit_name_what_fits(void) {
    const double sites[6] = {0.1, 0.2, 0.6, 0.3, 0.4, 0.9};
    pcvt_options options = options_for(8);
    options.symmetry = PCVT_SYMMETRY_P3;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "it fits hexagonal lattices");
    options.symmetry = PCVT_SYMMETRY_P4M;
    options.lattice[3] = 2;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "it fits squares");
    options.symmetry = PCVT_SYMMETRY_PM;
    options.lattice[2] = 0.37;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "it fits rectangles");
    options = options_for(7);
    options.symmetry = PCVT_SYMMETRY_PG;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "take 6 or 8");
    options = options_for(8);
    options.symmetry = PCVT_SYMMETRY_P2;
    options.start = PCVT_START_LATTICE;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "take coarse or random");
    options.start = PCVT_START_RANDOM;
    options.area_law = "equal";
    REFUSED(&options, PCVT_ERROR_ARGUMENT,
            "symmetry does not work with areas; leave one of them out");
    options = options_for(3);
    options.symmetry = PCVT_SYMMETRY_P2;
    options.sites = sites;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "symmetry draws its sites");
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
    options.duplicates = 2;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "duplicates 2");
    options.duplicates = PCVT_DUPLICATES_DROP;
    options.sites = NULL;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "duplicates is for given sites");
}

static void coincident_sites_are_dropped_with_their_areas(void) {
    const double sites[8] = {0.25, 0.5, 0.5, 0.5, 1.25, -0.5, 0.5, 0.5};
    const double areas[4] = {1, 2, 3, 4};
    pcvt_options options = options_for(4);
    pcvt_result* result;
    pcvt_statistics statistics;
    options.sites = sites;
    options.areas = areas;
    options.n_areas = 4;
    options.max_iterations = 0;
    REFUSED(
        &options, PCVT_ERROR_GEOMETRY,
        "2 sites coincide with earlier ones modulo the lattice: site 2 with site 0, site 3 with "
        "site 1; remove them");
    options.duplicates = PCVT_DUPLICATES_DROP;
    result = generated(&options);
    CHECK(pcvt_get_statistics(result, &statistics, sizeof statistics) == PCVT_OK);
    CHECK(statistics.n_sites == 2 && statistics.n_dropped == 2);
    CHECK(statistics.dropped[0] == 2 && statistics.dropped[1] == 0);
    CHECK(statistics.dropped[2] == 3 && statistics.dropped[3] == 1);
    pcvt_free(result);
}

static void weights_and_phases_of_sites_are_checked(void) {
    const double sites[6] = {0.2, 0.2, 0.3, 0.2, 0.7, 0.7};
    const double weights[3] = {0.1, 0, 0};
    const double wrong[3] = {0, NAN, 0};
    const int32_t phases[3] = {0, 1, 0};
    const int32_t none[3] = {0, 2, 0};
    pcvt_options options = options_for(3);
    pcvt_sites view;
    pcvt_result* result;
    options.sites = sites;
    options.weights = weights;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "n_weights is not n_sites");
    options.n_weights = 3;
    REFUSED(&options, PCVT_ERROR_ARGUMENT,
            "weights keeps sites where they are; add max_iterations 0");
    options.max_iterations = 0;
    REFUSED(&options, PCVT_ERROR_GEOMETRY, "the cell of site 1 is empty");
    options.weights = wrong;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "weights is not finite");
    options.weights = NULL;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "weights is a null pointer");
    options.n_weights = 0;
    options.site_phases = phases;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "set phases");
    options.phases = "a,b";
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "n_site_phases is not n_sites");
    options.n_site_phases = 3;
    options.site_phases = none;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "site_phases of site 1 is 2; take 0 to 1");
    options.site_phases = phases;
    result = generated(&options);
    CHECK(pcvt_get_sites(result, &view, sizeof view) == PCVT_OK);
    CHECK(view.n_phases == 2 && view.phases[0] == 0 && view.phases[1] == 1 && view.phases[2] == 0);
    CHECK(strcmp(view.phase_names[1], "b") == 0);
    pcvt_free(result);
    options.site_phases = NULL;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "site_phases is a null pointer");
}

static void cells_that_a_format_refuses_are_a_matter_of_geometry(void) {
    pcvt_options options = options_for(12);
    pcvt_result* result;
    options.max_iterations = 0;
    result = generated(&options);
    CHECK(pcvt_write(result, "t.nc", NULL) == PCVT_ERROR_GEOMETRY);
    CHECK(strstr(pcvt_last_error(), "t.nc") != NULL);
    pcvt_free(result);
}

static void every_status_has_a_distinct_text(void) {
    for (pcvt_status s = PCVT_ERROR_INTERNAL - 1; s <= PCVT_NOT_CONVERGED; ++s) {
        CHECK(strlen(pcvt_status_text(s)) > 3);
        for (pcvt_status t = s + 1; t <= PCVT_NOT_CONVERGED; ++t) {
            CHECK(strcmp(pcvt_status_text(s), pcvt_status_text(t)) != 0);
        }
    }
}

static void unknown_forms_of_files_are_refused(void) {
    pcvt_options options = options_for(5);
    pcvt_result* result = generated(&options);
    pcvt_write_options forms;
    memset(&forms, 0, sizeof forms);
    forms.struct_size = sizeof forms;
    forms.gltf_nodes = 9;
    CHECK(pcvt_write(result, "t.glb", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "gltf_nodes 9") != NULL);
    forms.gltf_nodes = PCVT_NODES_ONE;
    CHECK(pcvt_write(result, "t.obj", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), ".glb") != NULL);
    forms.gltf_nodes = PCVT_NODES_DEFAULT;
    forms.pixels = -1;
    CHECK(pcvt_write(result, "t.png", &forms) == PCVT_ERROR_ARGUMENT);
    forms.pixels = 0;
    forms.cut_width = (double)NAN;
    CHECK(pcvt_write(result, "t.dxf", &forms) == PCVT_ERROR_ARGUMENT);
    forms.cut_width = 0;
    forms.thickness = (double)NAN;
    CHECK(pcvt_write(result, "t.foam", &forms) == PCVT_ERROR_ARGUMENT);
    forms.thickness = -0.1;
    CHECK(pcvt_write(result, "t.foam", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "thickness is negative") != NULL);
    forms.thickness = 0.1;
    CHECK(pcvt_write(result, "t.obj", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "no output takes a thickness") != NULL);
    forms.thickness = 0;
    forms.element = 4;
    CHECK(pcvt_write(result, "t.inp", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "element 4") != NULL);
    forms.element = PCVT_CPE;
    forms.colour = 10;
    CHECK(pcvt_write(result, "t.svg", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "colour 10") != NULL);
    forms.colour = PCVT_COLOUR_FACES;
    CHECK(pcvt_write(result, "t.svg", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "colour faces is for three") != NULL);
    forms.colour = PCVT_COLOUR_DENSITY;
    CHECK(pcvt_write(result, "t.svg", &forms) == PCVT_ERROR_ARGUMENT);
    forms.colour = PCVT_COLOUR_ORBIT;
    CHECK(pcvt_write(result, "t.svg", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "colour orbit needs symmetry") != NULL);
    forms.colour = PCVT_COLOUR_TAG;
    CHECK(pcvt_write(result, "t.svg", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "colour tag needs inclusions or fibres") != NULL);
    forms.colour = PCVT_COLOUR_DEFAULT;
    forms.background = "#12345";
    CHECK(pcvt_write(result, "t.svg", &forms) == PCVT_ERROR_ARGUMENT);
    forms.background = NULL;
    forms.surface = PCVT_SURFACE_BOUNDARY;
    CHECK(pcvt_write(result, "t.obj", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "surface is for three dimensions") != NULL);
    forms.surface = PCVT_SURFACE_CELLS;
    forms.kind = -1;
    CHECK(pcvt_write(result, "t.obj", &forms) == PCVT_ERROR_ARGUMENT);
    forms.kind = PCVT_VORONOI;
    forms.outline = 2;
    CHECK(pcvt_write(result, "t.obj", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "outline 2") != NULL);
    forms.outline = PCVT_WHOLE;
    forms.pixels = INT32_MAX;
    CHECK(pcvt_write(result, "t.png", &forms) < 0);
    forms.pixels = 0;
    forms.report = "";
    CHECK(pcvt_write(result, NULL, &forms) == PCVT_ERROR_ARGUMENT);
    forms.report = NULL;
    CHECK(pcvt_write(result, "", &forms) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_write(result, "t.xyz", &forms) == PCVT_ERROR_ARGUMENT);
    pcvt_free(result);
}

static void files_that_cannot_fit_are_refused_before_they_are_made(void) {
    pcvt_options options = options_for(100000);
    pcvt_result* result = NULL;
    struct rlimit old;
    struct rlimit low;
    /* A sanitizer maps terabytes, which no limit may count. */
    if (mapped_memory() >> 40 != 0) return;
    options.max_iterations = 0;
    CHECK(pcvt_generate(&options, &result) == PCVT_OK);
    CHECK(getrlimit(RLIMIT_AS, &old) == 0);
    low = old;
    /* The files take 90 MB; without the estimate the run fails on the way. */
    low.rlim_cur = mapped_memory() + ((size_t)40 << 20);
    CHECK(setrlimit(RLIMIT_AS, &low) == 0);
    CHECK(pcvt_write(result, "t.gltf", NULL) == PCVT_ERROR_MEMORY);
    CHECK(strstr(pcvt_last_error(), "the files take about") != NULL);
    CHECK(setrlimit(RLIMIT_AS, &old) == 0);
    pcvt_free(result);
}

static void meshes_that_cannot_fit_are_refused_before_they_are_built(void) {
    pcvt_options options = options_for(100000);
    pcvt_result* result = NULL;
    pcvt_tile tile;
    pcvt_mesh mesh;
    struct rlimit old;
    struct rlimit low;
    int32_t kind;
    if (mapped_memory() >> 40 != 0) return;
    options.max_iterations = 0;
    options.grain_size = 1e-3;
    CHECK(pcvt_generate(&options, &result) == PCVT_OK);
    CHECK(getrlimit(RLIMIT_AS, &old) == 0);
    low = old;
    /* The smallest of these meshes takes 29 MB. */
    low.rlim_cur = mapped_memory() + ((size_t)16 << 20);
    CHECK(setrlimit(RLIMIT_AS, &low) == 0);
    for (kind = PCVT_VORONOI; kind <= PCVT_GRAINS; ++kind) {
        CHECK(pcvt_get_tile(result, kind, PCVT_WHOLE, &tile, sizeof tile) == PCVT_ERROR_MEMORY);
        CHECK(strstr(pcvt_last_error(), "takes about") != NULL);
        if (kind == PCVT_GRAINS) continue;
        CHECK(pcvt_get_mesh(result, kind, &mesh, sizeof mesh) == PCVT_ERROR_MEMORY);
        CHECK(strstr(pcvt_last_error(), "takes about") != NULL);
    }
    CHECK(setrlimit(RLIMIT_AS, &old) == 0);
    /* The refusals leave the result as it was. */
    CHECK(pcvt_get_tile(result, PCVT_DELAUNAY, PCVT_WHOLE, &tile, sizeof tile) == PCVT_OK);
    CHECK(pcvt_get_mesh(result, PCVT_VORONOI, &mesh, sizeof mesh) == PCVT_OK);
    pcvt_free(result);
}

int main(void) {
    sizes_and_versions_that_do_not_fit_are_refused();
    the_interface_has_the_version_of_the_library();
    a_longer_struct_is_accepted_if_its_tail_is_zero();
    a_struct_without_the_last_fields_is_accepted();
    reserved_fields_are_zero();
    views_have_the_size_that_the_host_states();
    null_pointers_are_refused();
    numbers_that_are_not_finite_are_refused();
    values_out_of_range_are_refused();
    every_field_is_checked();
    fields_that_contradict_each_other_are_refused();
    symmetries_that_do_not_fit_name_what_fits();
    unknown_tiles_are_refused();
    unknown_forms_of_files_are_refused();
    coincident_sites_are_named();
    coincident_sites_are_dropped_with_their_areas();
    weights_and_phases_of_sites_are_checked();
    cells_that_a_format_refuses_are_a_matter_of_geometry();
    every_status_has_a_distinct_text();
    files_that_cannot_fit_are_refused_before_they_are_made();
    meshes_that_cannot_fit_are_refused_before_they_are_built();
    return end_of_claims();
}
