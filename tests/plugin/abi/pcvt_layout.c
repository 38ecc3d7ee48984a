/* Prints the layout that a host of the C interface relies on: sizes of structs, offsets of fields
 * and values of constants. */
#include <pcvt.h>
#include <stdio.h>

#define STRUCT(type) printf("struct %s %d\n", #type, (int)sizeof(type))
#define FIELD(type, field)                                                   \
    printf("field %s.%s %d %d\n", #type, #field, (int)offsetof(type, field), \
           (int)sizeof(((type*)0)->field))
#define NUMBER(name) printf("number %s %d\n", #name, (int)(name))

static void print_numbers(void) {
    NUMBER(PCVT_ABI_VERSION);
    NUMBER(PCVT_OK);
    NUMBER(PCVT_CANCELLED);
    NUMBER(PCVT_NOT_CONVERGED);
    NUMBER(PCVT_REFUTED);
    NUMBER(PCVT_ERROR_ARGUMENT);
    NUMBER(PCVT_ERROR_ABI);
    NUMBER(PCVT_ERROR_DOMAIN);
    NUMBER(PCVT_ERROR_MEMORY);
    NUMBER(PCVT_ERROR_GEOMETRY);
    NUMBER(PCVT_ERROR_IO);
    NUMBER(PCVT_ERROR_INTERNAL);
    NUMBER(PCVT_START_DEFAULT);
    NUMBER(PCVT_START_RANDOM);
    NUMBER(PCVT_START_COARSE);
    NUMBER(PCVT_START_LATTICE);
    NUMBER(PCVT_START_BEST);
    NUMBER(PCVT_SOLVER_DEFAULT);
    NUMBER(PCVT_SOLVER_LBFGS);
    NUMBER(PCVT_SOLVER_LLOYD);
    NUMBER(PCVT_SOLVER_NEWTON);
    NUMBER(PCVT_VORONOI);
    NUMBER(PCVT_DELAUNAY);
    NUMBER(PCVT_GRAINS);
    NUMBER(PCVT_WHOLE);
    NUMBER(PCVT_BOX);
    NUMBER(PCVT_NODES_DEFAULT);
    NUMBER(PCVT_NODES_CELLS);
    NUMBER(PCVT_NODES_ONE);
    NUMBER(PCVT_CPE);
    NUMBER(PCVT_CPS);
    NUMBER(PCVT_JOB_NONE);
    NUMBER(PCVT_JOB_ELASTIC);
    NUMBER(PCVT_SURFACE_CELLS);
    NUMBER(PCVT_SURFACE_BOUNDARY);
    NUMBER(PCVT_COLOUR_DEFAULT);
    NUMBER(PCVT_COLOUR_SIDES);
    NUMBER(PCVT_COLOUR_SIZE);
    NUMBER(PCVT_COLOUR_CELLS);
    NUMBER(PCVT_COLOUR_DENSITY);
    NUMBER(PCVT_COLOUR_PHASE);
    NUMBER(PCVT_COLOUR_ORBIT);
    NUMBER(PCVT_COLOUR_TAG);
    NUMBER(PCVT_COLOUR_FACES);
    NUMBER(PCVT_COLOUR_ORIENTATION);
    NUMBER(PCVT_CIRCLE);
    NUMBER(PCVT_ELLIPSE);
    NUMBER(PCVT_POLYGON);
    NUMBER(PCVT_SYMMETRY_NONE);
    NUMBER(PCVT_SYMMETRY_P1);
    NUMBER(PCVT_SYMMETRY_P2);
    NUMBER(PCVT_SYMMETRY_PM);
    NUMBER(PCVT_SYMMETRY_PG);
    NUMBER(PCVT_SYMMETRY_CM);
    NUMBER(PCVT_SYMMETRY_PMM);
    NUMBER(PCVT_SYMMETRY_PMG);
    NUMBER(PCVT_SYMMETRY_PGG);
    NUMBER(PCVT_SYMMETRY_CMM);
    NUMBER(PCVT_SYMMETRY_P4);
    NUMBER(PCVT_SYMMETRY_P4M);
    NUMBER(PCVT_SYMMETRY_P4G);
    NUMBER(PCVT_SYMMETRY_P3);
    NUMBER(PCVT_SYMMETRY_P3M1);
    NUMBER(PCVT_SYMMETRY_P31M);
    NUMBER(PCVT_SYMMETRY_P6);
    NUMBER(PCVT_SYMMETRY_P6M);
    NUMBER(PCVT_DUPLICATES_REFUSE);
    NUMBER(PCVT_DUPLICATES_DROP);
    NUMBER(PCVT_STOP_CONVERGED);
    NUMBER(PCVT_STOP_ITERATION_LIMIT);
    NUMBER(PCVT_STOP_STALLED);
    NUMBER(PCVT_PHASE_START);
    NUMBER(PCVT_PHASE_OPTIMISE);
    NUMBER(PCVT_PHASE_BUILD);
    NUMBER(PCVT_PHASE_PROVE);
    NUMBER(PCVT_PHASE_WRITE);
    NUMBER(PCVT_MINIMUM_UNKNOWN);
    NUMBER(PCVT_MINIMUM_YES);
    NUMBER(PCVT_MINIMUM_NO);
}

static void print_progress(void) {
    STRUCT(pcvt_progress);
    FIELD(pcvt_progress, struct_size);
    FIELD(pcvt_progress, iteration);
    FIELD(pcvt_progress, evaluations);
    FIELD(pcvt_progress, energy);
    FIELD(pcvt_progress, energy_bound);
    FIELD(pcvt_progress, residual);
    FIELD(pcvt_progress, rms_residual);
    FIELD(pcvt_progress, phase);
    FIELD(pcvt_progress, reserved);
    FIELD(pcvt_progress, fraction);
    FIELD(pcvt_progress, phase_text);
}

static void print_options(void) {
    STRUCT(pcvt_options);
    FIELD(pcvt_options, struct_size);
    FIELD(pcvt_options, lattice);
    FIELD(pcvt_options, origin);
    FIELD(pcvt_options, sites);
    FIELD(pcvt_options, n_sites);
    FIELD(pcvt_options, start);
    FIELD(pcvt_options, seed);
    FIELD(pcvt_options, solver);
    FIELD(pcvt_options, max_iterations);
    FIELD(pcvt_options, tolerance);
    FIELD(pcvt_options, n_threads);
    FIELD(pcvt_options, columns);
    FIELD(pcvt_options, rows);
    FIELD(pcvt_options, grain_order);
    FIELD(pcvt_options, grain_size);
    FIELD(pcvt_options, short_edges);
    FIELD(pcvt_options, budget);
    FIELD(pcvt_options, density_source);
    FIELD(pcvt_options, density_range);
    FIELD(pcvt_options, density);
    FIELD(pcvt_options, density_data);
    FIELD(pcvt_options, progress);
    FIELD(pcvt_options, progress_data);
    FIELD(pcvt_options, grain_per_edge);
    FIELD(pcvt_options, find_origin);
    FIELD(pcvt_options, areas);
    FIELD(pcvt_options, n_areas);
    FIELD(pcvt_options, reserved);
    FIELD(pcvt_options, area_law);
    FIELD(pcvt_options, aspect);
    FIELD(pcvt_options, aspect_degrees);
    FIELD(pcvt_options, phases);
    FIELD(pcvt_options, orientations);
    FIELD(pcvt_options, n_orientations);
    FIELD(pcvt_options, random_orientations);
    FIELD(pcvt_options, symmetry);
    FIELD(pcvt_options, walls);
    FIELD(pcvt_options, wall_cells);
    FIELD(pcvt_options, reserved2);
    FIELD(pcvt_options, inclusions);
    FIELD(pcvt_options, fibres);
    FIELD(pcvt_options, fixed_sites);
    FIELD(pcvt_options, n_fixed_sites);
    FIELD(pcvt_options, reserved3);
    FIELD(pcvt_options, holes);
    FIELD(pcvt_options, dimension);
    FIELD(pcvt_options, reserved4);
    FIELD(pcvt_options, lattice3);
    FIELD(pcvt_options, duplicates);
    FIELD(pcvt_options, n_weights);
    FIELD(pcvt_options, weights);
    FIELD(pcvt_options, site_phases);
    FIELD(pcvt_options, n_site_phases);
    FIELD(pcvt_options, reserved5);
    FIELD(pcvt_options, origin_z);
    FIELD(pcvt_options, volumes);
    FIELD(pcvt_options, volume_law);
    FIELD(pcvt_options, n_volumes);
    FIELD(pcvt_options, reserved6);
    FIELD(pcvt_options, orientation_weights);
    FIELD(pcvt_options, aspect_axis);
    FIELD(pcvt_options, layers);
    FIELD(pcvt_options, sites_are_centroids);
}

static void print_sites(void) {
    STRUCT(pcvt_sites);
    FIELD(pcvt_sites, lattice);
    FIELD(pcvt_sites, points);
    FIELD(pcvt_sites, n_sites);
    FIELD(pcvt_sites, reserved);
    FIELD(pcvt_sites, weights);
    FIELD(pcvt_sites, phases);
    FIELD(pcvt_sites, phase_names);
    FIELD(pcvt_sites, orientations);
    FIELD(pcvt_sites, n_phases);
    FIELD(pcvt_sites, n_orbits);
    FIELD(pcvt_sites, orbits);
}

static void print_inclusions(void) {
    STRUCT(pcvt_inclusions);
    FIELD(pcvt_inclusions, numbers);
    FIELD(pcvt_inclusions, begin);
    FIELD(pcvt_inclusions, form);
    FIELD(pcvt_inclusions, tags);
    FIELD(pcvt_inclusions, n_shapes);
    FIELD(pcvt_inclusions, reserved);
}

static void print_mesh(void) {
    STRUCT(pcvt_mesh);
    FIELD(pcvt_mesh, lattice);
    FIELD(pcvt_mesh, vertices);
    FIELD(pcvt_mesh, face_begin);
    FIELD(pcvt_mesh, corner_vertex);
    FIELD(pcvt_mesh, corner_offset);
    FIELD(pcvt_mesh, opposite);
    FIELD(pcvt_mesh, site);
    FIELD(pcvt_mesh, site_points);
    FIELD(pcvt_mesh, kind);
    FIELD(pcvt_mesh, n_vertices);
    FIELD(pcvt_mesh, n_faces);
    FIELD(pcvt_mesh, n_corners);
}

static void print_edge_pair(void) {
    STRUCT(pcvt_edge_pair);
    FIELD(pcvt_edge_pair, v0);
    FIELD(pcvt_edge_pair, v1);
    FIELD(pcvt_edge_pair, w0);
    FIELD(pcvt_edge_pair, w1);
    FIELD(pcvt_edge_pair, i);
    FIELD(pcvt_edge_pair, j);
}

static void print_tile(void) {
    STRUCT(pcvt_tile);
    FIELD(pcvt_tile, lattice);
    FIELD(pcvt_tile, points);
    FIELD(pcvt_tile, face_begin);
    FIELD(pcvt_tile, corners);
    FIELD(pcvt_tile, face_site);
    FIELD(pcvt_tile, site_points);
    FIELD(pcvt_tile, vertex_site);
    FIELD(pcvt_tile, vertex_orbit);
    FIELD(pcvt_tile, vertex_offset);
    FIELD(pcvt_tile, edge_pairs);
    FIELD(pcvt_tile, kind);
    FIELD(pcvt_tile, outline);
    FIELD(pcvt_tile, n_vertices);
    FIELD(pcvt_tile, n_faces);
    FIELD(pcvt_tile, n_corners);
    FIELD(pcvt_tile, n_edge_pairs);
    FIELD(pcvt_tile, wall_edges);
    FIELD(pcvt_tile, n_wall_edges);
    FIELD(pcvt_tile, n_holes);
    FIELD(pcvt_tile, hole_names);
}

static void print_cells(void) {
    STRUCT(pcvt_cells);
    FIELD(pcvt_cells, lattice);
    FIELD(pcvt_cells, points);
    FIELD(pcvt_cells, point_orbit);
    FIELD(pcvt_cells, point_offset);
    FIELD(pcvt_cells, face_begin);
    FIELD(pcvt_cells, face_points);
    FIELD(pcvt_cells, owner);
    FIELD(pcvt_cells, neighbour);
    FIELD(pcvt_cells, partner);
    FIELD(pcvt_cells, partner_offset);
    FIELD(pcvt_cells, volumes);
    FIELD(pcvt_cells, site_points);
    FIELD(pcvt_cells, sites);
    FIELD(pcvt_cells, n_cells);
    FIELD(pcvt_cells, n_faces);
    FIELD(pcvt_cells, n_inner_faces);
    FIELD(pcvt_cells, n_points);
    FIELD(pcvt_cells, n_face_points);
    FIELD(pcvt_cells, n_phases);
    FIELD(pcvt_cells, phases);
    FIELD(pcvt_cells, phase_names);
    FIELD(pcvt_cells, orientations);
    FIELD(pcvt_cells, weights);
}

static void print_statistics(void) {
    STRUCT(pcvt_statistics);
    FIELD(pcvt_statistics, energy);
    FIELD(pcvt_statistics, energy_bound);
    FIELD(pcvt_statistics, residual);
    FIELD(pcvt_statistics, rms_residual);
    FIELD(pcvt_statistics, seconds_build);
    FIELD(pcvt_statistics, seconds_optimize);
    FIELD(pcvt_statistics, valences);
    FIELD(pcvt_statistics, n_valences);
    FIELD(pcvt_statistics, n_hexagons);
    FIELD(pcvt_statistics, stop);
    FIELD(pcvt_statistics, n_sites);
    FIELD(pcvt_statistics, iterations);
    FIELD(pcvt_statistics, evaluations);
    FIELD(pcvt_statistics, n_threads);
    FIELD(pcvt_statistics, n_mirrors);
    FIELD(pcvt_statistics, area_error);
    FIELD(pcvt_statistics, newton_steps);
    FIELD(pcvt_statistics, n_dropped);
    FIELD(pcvt_statistics, dropped);
}

static void print_write_options(void) {
    STRUCT(pcvt_write_options);
    FIELD(pcvt_write_options, struct_size);
    FIELD(pcvt_write_options, report);
    FIELD(pcvt_write_options, kind);
    FIELD(pcvt_write_options, outline);
    FIELD(pcvt_write_options, replace);
    FIELD(pcvt_write_options, colour);
    FIELD(pcvt_write_options, progress);
    FIELD(pcvt_write_options, progress_data);
    FIELD(pcvt_write_options, gltf_nodes);
    FIELD(pcvt_write_options, single_precision);
    FIELD(pcvt_write_options, pixels);
    FIELD(pcvt_write_options, element);
    FIELD(pcvt_write_options, cut_width);
    FIELD(pcvt_write_options, background);
    FIELD(pcvt_write_options, voxels);
    FIELD(pcvt_write_options, job);
    FIELD(pcvt_write_options, voxel_layers);
    FIELD(pcvt_write_options, thickness);
    FIELD(pcvt_write_options, surface);
    FIELD(pcvt_write_options, reserved2);
    FIELD(pcvt_write_options, materials);
    FIELD(pcvt_write_options, coriolis);
}

static void print_check_options(void) {
    STRUCT(pcvt_check_options);
    FIELD(pcvt_check_options, struct_size);
    FIELD(pcvt_check_options, lattice);
    FIELD(pcvt_check_options, tolerance);
    FIELD(pcvt_check_options, cvt);
    FIELD(pcvt_check_options, areas);
    FIELD(pcvt_check_options, inclusions);
    FIELD(pcvt_check_options, density);
    FIELD(pcvt_check_options, density_range);
    FIELD(pcvt_check_options, progress);
    FIELD(pcvt_check_options, progress_data);
    FIELD(pcvt_check_options, volumes);
}

static void print_study_options(void) {
    STRUCT(pcvt_study_options);
    FIELD(pcvt_study_options, struct_size);
    FIELD(pcvt_study_options, name);
    FIELD(pcvt_study_options, sites);
    FIELD(pcvt_study_options, n_sites);
    FIELD(pcvt_study_options, runs);
    FIELD(pcvt_study_options, seed);
    FIELD(pcvt_study_options, n_threads);
    FIELD(pcvt_study_options, replace);
    FIELD(pcvt_study_options, path);
    FIELD(pcvt_study_options, progress);
    FIELD(pcvt_study_options, progress_data);
}

static void print_study_contents(void) {
    STRUCT(pcvt_study_contents);
    FIELD(pcvt_study_contents, text);
    FIELD(pcvt_study_contents, n_tables);
    FIELD(pcvt_study_contents, n_pictures);
}

static void print_table(void) {
    STRUCT(pcvt_table);
    FIELD(pcvt_table, name);
    FIELD(pcvt_table, columns);
    FIELD(pcvt_table, cells);
    FIELD(pcvt_table, notes);
    FIELD(pcvt_table, n_columns);
    FIELD(pcvt_table, n_rows);
    FIELD(pcvt_table, n_notes);
    FIELD(pcvt_table, reserved);
}

static void print_picture(void) {
    STRUCT(pcvt_picture);
    FIELD(pcvt_picture, name);
    FIELD(pcvt_picture, svg);
}

int main(void) {
    print_numbers();
    print_progress();
    print_options();
    print_sites();
    print_inclusions();
    print_mesh();
    print_edge_pair();
    print_tile();
    print_cells();
    print_statistics();
    print_write_options();
    print_check_options();
    print_study_options();
    print_study_contents();
    print_table();
    print_picture();
    return 0;
}
