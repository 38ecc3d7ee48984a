/* Calls in three dimensions that the C interface refuses, each with its documented status. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <sys/resource.h>

#include "tests/support/mapped_memory.h"
#include "tests/support/space_claims.h"

static int some_density(const double* points, size_t n_points, double* values, void* data) {
    (void)points, (void)data;
    while (n_points-- > 0) *values++ = 1;
    return 0;
}

/* One field at a time, with a value that runs in the plane have. Its name begins the message. */
static void each_field_of_the_plane_is_refused_by_its_name(void) {
#define PLANE_FIELD(field, name, value)                                \
    do {                                                               \
        pcvt_options changed = space_options_for(3);                   \
        changed.field = (value);                                       \
        REFUSED(&changed, PCVT_ERROR_ARGUMENT, "three dimensions");    \
        CHECK(strncmp(pcvt_last_error(), name " ", sizeof name) == 0); \
    } while (0)
    const double three[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    PLANE_FIELD(lattice[2], "lattice", 0.5);
    PLANE_FIELD(grain_per_edge, "grain_per_edge", 2);
    PLANE_FIELD(walls, "walls", PCVT_WALLS_Y);
    PLANE_FIELD(wall_cells, "wall_cells", PCVT_WALL_CELLS_HALF);
    PLANE_FIELD(inclusions, "inclusions", "circle a 0.5 0.5 0.1");
    PLANE_FIELD(fibres, "fibres", "0.2,2");
    PLANE_FIELD(holes, "holes", "fibre");
    PLANE_FIELD(budget, "budget", 5);
    PLANE_FIELD(density_source, "density_source", "1");
    PLANE_FIELD(density_range[1], "density_range", 1);
    PLANE_FIELD(density, "density", some_density);
    PLANE_FIELD(density_data, "density_data", &n_failed);
    PLANE_FIELD(areas, "areas", three);
    PLANE_FIELD(n_areas, "n_areas", 3);
    PLANE_FIELD(area_law, "area_law", "equal");
    PLANE_FIELD(aspect_degrees, "aspect_degrees", 30);
    PLANE_FIELD(symmetry, "symmetry", PCVT_SYMMETRY_P1);
    PLANE_FIELD(fixed_sites, "fixed_sites", three);
    PLANE_FIELD(n_fixed_sites, "n_fixed_sites", 1);
    PLANE_FIELD(start, "start", PCVT_START_BEST);
    PLANE_FIELD(start, "start", 77);
    PLANE_FIELD(solver, "solver", PCVT_SOLVER_NEWTON);
    PLANE_FIELD(solver, "solver", -1);
#undef PLANE_FIELD
}

static void values_out_of_range_are_refused(void) {
    const double sites[6] = {0.1, 0.2, 0.3, 0.6, 0.5, (double)NAN};
    pcvt_options options = space_options_for(0);
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "n_sites");
    options = space_options_for((1 << 26) + 1);
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "n_sites");
    options = space_options_for(2);
    options.tolerance = 0;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "tolerance");
    options = space_options_for(2);
    options.n_threads = 1025;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "n_threads");
    options = space_options_for(2);
    options.sites = sites;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "site 1");
    options.n_sites = 1;
    options.start = PCVT_START_RANDOM;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "start");
    options = space_options_for(2);
    options.lattice3[8] = 0;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "lattice3: ");
    options.lattice3[8] = (double)INFINITY;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "lattice3 is not finite");
    options = space_options_for(2);
    options.aspect = 0;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "aspect");
    options.aspect = 2;
    options.aspect_axis[1] = (double)NAN;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "aspect_axis");
    options = options_for(2);
    options.aspect_axis[1] = 1;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "aspect_axis is for three dimensions");
    options = space_options_for(2);
    options.sites_are_centroids = 1;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "sites_are_centroids");
    options = space_options_for(2);
    options.reserved4 = 1;
    REFUSED(&options, PCVT_ERROR_ABI, "does not know");
}

static void the_dimension_decides_which_lattice_counts(void) {
    pcvt_options options = options_for(4);
    CHECK(options.dimension == 2);
    options.dimension = 4;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "dimension 4");
    options.dimension = 0;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "dimension 0");
    options.dimension = 2;
    options.lattice3[0] = 2;
    REFUSED(&options, PCVT_ERROR_ARGUMENT, "lattice3 is for three dimensions");
}

static void coincident_sites_are_named(void) {
    const double sites[9] = {0.25, 0.5, 0, 0.5, 0.5, 0, 1.25, -0.5, 3};
    pcvt_options options = space_options_for(3);
    options.sites = sites;
    REFUSED(&options, PCVT_ERROR_GEOMETRY, "sites 0 and 2");
}

static void near_sites_are_dropped(void) {
    const double sites[9] = {0.25, 0.5, 0, 0.5, 0.5, 0, 1.25 + 1e-11, -0.5, 3};
    pcvt_options options = space_options_for(3);
    pcvt_result* result;
    pcvt_statistics statistics;
    options.sites = sites;
    options.max_iterations = 0;
    REFUSED(&options, PCVT_ERROR_GEOMETRY, "sites 0 and 2");
    options.duplicates = PCVT_DUPLICATES_DROP;
    result = generated(&options);
    CHECK(pcvt_get_statistics(result, &statistics, sizeof statistics) == PCVT_OK);
    CHECK(statistics.n_sites == 2 && statistics.n_dropped == 1);
    CHECK(statistics.dropped[0] == 2 && statistics.dropped[1] == 0);
    pcvt_free(result);
}

static void views_of_the_other_dimension_name_their_function(void) {
    pcvt_options options = space_options_for(3);
    pcvt_result* result = generated(&options);
    pcvt_sites sites;
    pcvt_inclusions inclusions;
    pcvt_mesh mesh;
    pcvt_tile tile;
    pcvt_cells cells;
#define NAMES_CELLS(call)                                           \
    do {                                                            \
        CHECK((call) == PCVT_ERROR_ARGUMENT);                       \
        CHECK(strstr(pcvt_last_error(), "pcvt_get_cells") != NULL); \
    } while (0)
    NAMES_CELLS(pcvt_get_sites(result, &sites, sizeof sites));
    NAMES_CELLS(pcvt_get_inclusions(result, &inclusions, sizeof inclusions));
    NAMES_CELLS(pcvt_get_mesh(result, PCVT_VORONOI, &mesh, sizeof mesh));
    NAMES_CELLS(pcvt_get_tile(result, PCVT_VORONOI, PCVT_WHOLE, &tile, sizeof tile));
#undef NAMES_CELLS
    CHECK(pcvt_get_cells(result, &cells, sizeof cells - 1) == PCVT_ERROR_ABI);
    CHECK(pcvt_get_cells(result, NULL, sizeof cells) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_cells(NULL, &cells, sizeof cells) == PCVT_ERROR_ARGUMENT);
    pcvt_free(result);
    options = options_for(3);
    result = generated(&options);
    CHECK(pcvt_get_cells(result, &cells, sizeof cells) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "pcvt_get_tile") != NULL);
    pcvt_free(result);
}

/* Writes with one field changed; the message begins with its name. */
static void each_field_of_files_in_the_plane_is_refused_by_its_name(void) {
    pcvt_options options = space_options_for(3);
    pcvt_result* result = generated(&options);
#define PLANE_FIELD(field, name, value)                                          \
    do {                                                                         \
        pcvt_write_options how = {0};                                            \
        how.struct_size = sizeof how;                                            \
        how.field = (value);                                                     \
        CHECK(pcvt_write(result, "refused.vtu", &how) == PCVT_ERROR_ARGUMENT);   \
        CHECK(strncmp(pcvt_last_error(), name " is not for", sizeof name) == 0); \
        CHECK(!removes_file("refused.vtu"));                                     \
    } while (0)
    PLANE_FIELD(colour, "colour 1", PCVT_COLOUR_SIDES);
    PLANE_FIELD(gltf_nodes, "gltf_nodes", PCVT_NODES_ONE);
    PLANE_FIELD(single_precision, "single_precision", 1);
    PLANE_FIELD(pixels, "pixels", 64);
    PLANE_FIELD(element, "element", PCVT_CPS);
    PLANE_FIELD(cut_width, "cut_width", 100);
    PLANE_FIELD(background, "background", "none");
    PLANE_FIELD(coriolis[0], "coriolis", 1e-4);
    PLANE_FIELD(thickness, "thickness", 0.1);
#undef PLANE_FIELD
    pcvt_write_options job = {0};
    job.struct_size = sizeof job;
    job.job = PCVT_JOB_ELASTIC;
    CHECK(pcvt_write(result, "refused.vtu", &job) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "no output takes a job of a solver; add one of .inp") != NULL);
    CHECK(!removes_file("refused.vtu"));
    CHECK(pcvt_write(result, NULL, NULL) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_write(result, "", NULL) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_write(result, "refused.nc", NULL) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(),
                 ".obj, .ply, .glb, .om, .stl, .msh, .inp, .vtu, .svg, .png, .foam, .vti, .csv or "
                 ".txt") != NULL);
    pcvt_free(result);
}

static void voxels_need_three_counts_and_files_that_have_them(void) {
    pcvt_options options = space_options_for(8);
    pcvt_result* result = generated(&options);
    pcvt_write_options how = {0};
    how.struct_size = sizeof how;
    how.voxels[0] = how.voxels[1] = 8;
    CHECK(pcvt_write(result, "refused.vti", &how) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "three counts, NX,NY,NZ") != NULL);
    how.voxel_layers = 6;
    CHECK(pcvt_write(result, "refused.vtu", &how) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "a number of voxels; add one of .vti") != NULL);
    CHECK(pcvt_write(result, "space_voxels.vti", &how) == PCVT_OK);
    CHECK(removes_file("space_voxels.vti") && removes_file("space_voxels.material.yaml"));
    how.voxels[0] = how.voxels[1] = 0;
    CHECK(pcvt_write(result, "refused.vti", &how) == PCVT_ERROR_ARGUMENT);
    how.voxel_layers = 0;
    how.materials = "GRAINS:200,0.3";
    CHECK(pcvt_write(result, "space_voxels.vti", &how) == PCVT_OK);
    CHECK(removes_file("space_voxels.vti") && removes_file("space_voxels.material.yaml"));
    CHECK(!removes_file("refused.vti"));
    pcvt_free(result);
}

static void surfaces_are_for_files_that_have_them(void) {
    pcvt_options options = space_options_for(8);
    pcvt_result* result = generated(&options);
    pcvt_write_options how = {0};
    how.struct_size = sizeof how;
    how.surface = 2;
    CHECK(pcvt_write(result, "refused.obj", &how) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "surface 2 is unknown") != NULL);
    how.surface = PCVT_SURFACE_BOUNDARY;
    CHECK(pcvt_write(result, "refused.vtu", &how) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "surface is for .obj, .ply, .glb or .stl") != NULL);
    CHECK(pcvt_write(result, "refused.xyz", &how) == PCVT_ERROR_ARGUMENT);
    CHECK(strncmp(pcvt_last_error(), "refused.xyz: unknown extension", 30) == 0);
    pcvt_free(result);
}

static void tetrahedra_are_for_files_that_hold_them(void) {
    pcvt_options options = space_options_for(8);
    pcvt_result* result = generated(&options);
    pcvt_write_options how = {0};
    how.struct_size = sizeof how;
    how.kind = PCVT_GRAINS + 1;
    CHECK(pcvt_write(result, "refused.vtu", &how) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "take PCVT_VORONOI, PCVT_DELAUNAY or PCVT_GRAINS") != NULL);
    how.kind = PCVT_GRAINS;
    CHECK(pcvt_write(result, "refused.obj", &how) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_write(result, "grains.msh", &how) == PCVT_OK);
    CHECK(removes_file("grains.msh"));
    how.kind = PCVT_DELAUNAY;
    CHECK(pcvt_write(result, "refused.foam", &how) == PCVT_ERROR_ARGUMENT);
    CHECK(strstr(pcvt_last_error(), "the format holds no Delaunay tetrahedra; take .msh") != NULL);
    CHECK(pcvt_write(result, "tetrahedra.vtu", &how) == PCVT_OK);
    CHECK(removes_file("tetrahedra.vtu"));
    pcvt_free(result);
}

static void flat_tetrahedra_are_a_matter_of_geometry(void) {
    pcvt_options options = space_options_for(38);
    options.start = PCVT_START_LATTICE;
    pcvt_result* result = generated(&options);
    CHECK(pcvt_write(result, "flat.msh", NULL) == PCVT_ERROR_GEOMETRY);
    CHECK(strstr(pcvt_last_error(), "are flat") != NULL);
    CHECK(!removes_file("flat.msh"));
    pcvt_free(result);
}

static void what_cannot_fit_is_refused_before_it_is_made(void) {
    pcvt_options options = space_options_for(30000);
    pcvt_result* result = NULL;
    pcvt_cells cells;
    struct rlimit old;
    struct rlimit low;
    /* A sanitizer maps terabytes, which no limit may count. */
    if (mapped_memory() >> 40 != 0) return;
    options.max_iterations = 0;
    CHECK(pcvt_generate(&options, &result) == PCVT_OK);
    CHECK(getrlimit(RLIMIT_AS, &old) == 0);
    low = old;
    /* The cells take about 100 MB more. */
    low.rlim_cur = mapped_memory() + ((size_t)40 << 20);
    CHECK(setrlimit(RLIMIT_AS, &low) == 0);
    CHECK(pcvt_get_cells(result, &cells, sizeof cells) == PCVT_ERROR_MEMORY);
    CHECK(strstr(pcvt_last_error(), "the cells take about") != NULL);
    CHECK(pcvt_write(result, "large.vtu", NULL) == PCVT_ERROR_MEMORY);
    CHECK(strstr(pcvt_last_error(), "the files take about") != NULL);
    CHECK(!removes_file("large.vtu"));
    REFUSED(&options, PCVT_ERROR_MEMORY, "the run takes about");
    CHECK(setrlimit(RLIMIT_AS, &old) == 0);
    /* The refusals leave the result as it was. */
    CHECK(pcvt_get_cells(result, &cells, sizeof cells) == PCVT_OK);
    pcvt_free(result);
}

int main(void) {
    each_field_of_the_plane_is_refused_by_its_name();
    values_out_of_range_are_refused();
    the_dimension_decides_which_lattice_counts();
    coincident_sites_are_named();
    near_sites_are_dropped();
    views_of_the_other_dimension_name_their_function();
    each_field_of_files_in_the_plane_is_refused_by_its_name();
    voxels_need_three_counts_and_files_that_have_them();
    surfaces_are_for_files_that_have_them();
    tetrahedra_are_for_files_that_hold_them();
    flat_tetrahedra_are_a_matter_of_geometry();
    what_cannot_fit_is_refused_before_it_is_made();
    return end_of_claims();
}
