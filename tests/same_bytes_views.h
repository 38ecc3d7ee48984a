/* What tests/same_bytes prints of the views of a result of the C interface. */
#ifndef PCVT_TESTS_SAME_BYTES_VIEWS_H
#define PCVT_TESTS_SAME_BYTES_VIEWS_H

#include <pcvt.h>
#include <stdio.h>
#include <string.h>

static void print_doubles(const char* name, const double* values, int32_t n, int width) {
    int32_t k;
    printf("%s%s", name, values == NULL ? " NULL\n" : n > 0 ? "" : " empty\n");
    for (k = 0; values != NULL && k < n * width; ++k)
        printf("%s%.17g%s", k % width == 0 ? "\n " : " ", values[k],
               k == n * width - 1 ? "\n" : "");
}

static void print_integers(const char* name, const int32_t* values, int32_t n, int width) {
    int32_t k;
    printf("%s%s", name, values == NULL ? " NULL\n" : n > 0 ? "" : " empty\n");
    for (k = 0; values != NULL && k < n * width; ++k)
        printf("%s%d%s", k % (4 * width) == 0 ? "\n " : " ", values[k],
               k == n * width - 1 ? "\n" : "");
}

static void print_texts(const char* name, const char* const* texts, int32_t n) {
    int32_t k;
    printf("%s%s", name, texts == NULL ? " NULL" : "");
    for (k = 0; texts != NULL && k < n; ++k) printf(" \"%s\"", texts[k]);
    printf("\n");
}

/* Prints how a call ended. Returns the status. */
static pcvt_status said(const char* call, pcvt_status status) {
    printf("%s: status %d (%s), \"%s\"\n", call, status, pcvt_status_text(status),
           pcvt_last_error());
    return status;
}

static void print_statistics(const pcvt_result* result) {
    pcvt_statistics s;
    int32_t minimum = -1;
    memset(&s, 0, sizeof s);
    if (said("pcvt_get_statistics", pcvt_get_statistics(result, &s, sizeof s)) < 0) return;
    printf("energy %.17g of %.17g, residual %.17g, %.17g\n", s.energy, s.energy_bound, s.residual,
           s.rms_residual);
    printf("seconds not negative: %d\n", s.seconds_build >= 0 && s.seconds_optimize >= 0);
    print_integers("valences", s.valences, s.n_valences, 1);
    printf("hexagons %d, stop %d, sites %d, iterations %d, evaluations %d, threads %d\n",
           s.n_hexagons, s.stop, s.n_sites, s.iterations, s.evaluations, s.n_threads);
    printf("mirrors %d, area error %.17g, Newton steps %d, dropped %d\n", s.n_mirrors, s.area_error,
           s.newton_steps, s.n_dropped);
    said("pcvt_get_minimum", pcvt_get_minimum(result, &minimum));
    printf("minimum %d\n", minimum);
}

static void print_sites(const pcvt_result* result) {
    pcvt_sites s;
    pcvt_inclusions i;
    memset(&s, 0, sizeof s);
    memset(&i, 0, sizeof i);
    if (said("pcvt_get_sites", pcvt_get_sites(result, &s, sizeof s)) >= 0) {
        print_doubles("lattice", s.lattice, 2, 2);
        print_doubles("points", s.points, s.n_sites, 2);
        print_doubles("weights", s.weights, s.n_sites, 1);
        print_integers("phases", s.phases, s.n_sites, 1);
        print_texts("phase names", s.phase_names, s.n_phases);
        print_doubles("orientations", s.orientations, s.n_sites, 3);
        printf("orbits %d\n", s.n_orbits);
        print_integers("orbits", s.orbits, s.n_sites, 1);
    }
    if (said("pcvt_get_inclusions", pcvt_get_inclusions(result, &i, sizeof i)) < 0) return;
    printf("shapes %d\n", i.n_shapes);
    if (i.n_shapes == 0) return;
    print_integers("begin", i.begin, i.n_shapes + 1, 1);
    print_doubles("numbers", i.numbers, i.begin[i.n_shapes], 1);
    print_integers("form", i.form, i.n_shapes, 1);
    print_texts("tags", i.tags, i.n_shapes);
}

static void print_mesh(const pcvt_result* result, int32_t kind) {
    pcvt_mesh m;
    memset(&m, 0, sizeof m);
    printf("mesh %d\n", kind);
    if (said("pcvt_get_mesh", pcvt_get_mesh(result, kind, &m, sizeof m)) < 0) return;
    printf("kind %d\n", m.kind);
    print_doubles("lattice", m.lattice, 2, 2);
    print_doubles("vertices", m.vertices, m.n_vertices, 2);
    print_integers("face_begin", m.face_begin, m.n_faces + 1, 1);
    print_integers("corner_vertex", m.corner_vertex, m.n_corners, 1);
    print_integers("corner_offset", m.corner_offset, m.n_corners, 2);
    print_integers("opposite", m.opposite, m.n_corners, 1);
    print_integers("site", m.site, m.site_points == NULL ? m.n_vertices : m.n_faces, 1);
    print_doubles("site_points", m.site_points, m.n_faces, 2);
}

static void print_tile(const pcvt_result* result, int32_t kind, int32_t outline) {
    pcvt_tile t;
    memset(&t, 0, sizeof t);
    printf("tile %d, outline %d\n", kind, outline);
    if (said("pcvt_get_tile", pcvt_get_tile(result, kind, outline, &t, sizeof t)) < 0) return;
    printf("kind %d, outline %d, holes %d\n", t.kind, t.outline, t.n_holes);
    print_doubles("lattice", t.lattice, 2, 2);
    print_doubles("points", t.points, t.n_vertices, 2);
    print_integers("face_begin", t.face_begin, t.n_faces + 1, 1);
    print_integers("corners", t.corners, t.n_corners, 1);
    print_integers("face_site", t.face_site, t.n_faces, 1);
    print_doubles("site_points", t.site_points, t.n_faces, 2);
    print_integers("vertex_site", t.vertex_site, t.n_vertices, 1);
    print_integers("vertex_orbit", t.vertex_orbit, t.n_vertices, 1);
    print_integers("vertex_offset", t.vertex_offset, t.n_vertices, 2);
    print_integers("edge_pairs", (const int32_t*)t.edge_pairs, t.n_edge_pairs, 6);
    print_integers("wall_edges", (const int32_t*)t.wall_edges, t.n_wall_edges, 3);
    print_texts("hole_names", t.hole_names, t.n_holes);
}

static void print_cells(const pcvt_result* result) {
    pcvt_cells c;
    memset(&c, 0, sizeof c);
    if (said("pcvt_get_cells", pcvt_get_cells(result, &c, sizeof c)) < 0) return;
    printf("inner faces %d\n", c.n_inner_faces);
    print_doubles("lattice", c.lattice, 3, 3);
    print_doubles("points", c.points, c.n_points, 3);
    print_integers("point_orbit", c.point_orbit, c.n_points, 1);
    print_integers("point_offset", c.point_offset, c.n_points, 3);
    print_integers("face_begin", c.face_begin, c.n_faces + 1, 1);
    print_integers("face_points", c.face_points, c.n_face_points, 1);
    print_integers("owner", c.owner, c.n_faces, 1);
    print_integers("neighbour", c.neighbour, c.n_faces, 1);
    print_integers("partner", c.partner, c.n_faces - c.n_inner_faces, 1);
    print_integers("partner_offset", c.partner_offset, c.n_faces - c.n_inner_faces, 3);
    print_doubles("volumes", c.volumes, c.n_cells, 1);
    print_doubles("site_points", c.site_points, c.n_cells, 3);
    print_doubles("sites", c.sites, c.n_cells, 3);
}

static void print_views(const pcvt_result* result) {
    int32_t kind, outline;
    print_statistics(result);
    print_sites(result);
    for (kind = PCVT_VORONOI; kind <= PCVT_GRAINS; ++kind) {
        print_mesh(result, kind);
        for (outline = PCVT_WHOLE; outline <= PCVT_BOX; ++outline)
            print_tile(result, kind, outline);
    }
    print_cells(result);
}

#endif
