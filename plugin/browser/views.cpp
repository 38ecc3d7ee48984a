// Views of a result for JavaScript: each is a list of arrays in the memory of the module, in the
// order in which package/views.js names them.
#include <emscripten.h>

#include <cstdint>
#include <string>

#include "plugin/browser/run.hpp"
#include "plugin/pcvt.h"

namespace pcvt::browser {
namespace {

/// An array of numbers: its address, which is null where the result does not have it, and its
/// length.
struct Array {
    const void* begin;
    std::int32_t n;
};

std::string listed(const char* const* names, int n) {
    std::string text;
    for (int k = 0; k < n; ++k) text += (k == 0 ? "" : ",") + std::string(names[k]);
    return text;
}

}  // namespace

extern "C" {

/// Gives the arrays of a result in the plane. @param names  becomes the names of the phases, with
/// commas.
EMSCRIPTEN_KEEPALIVE int view_sites(const Run* run, Array* arrays, const char** names) {
    static pcvt_sites view;
    static std::string phases;
    const pcvt_status status = pcvt_get_sites(run->result, &view, sizeof view);
    if (status != PCVT_OK) return status;
    *arrays++ = {view.lattice, 4};
    *arrays++ = {view.weights, view.n_sites};
    *arrays++ = {view.phases, view.n_sites};
    *arrays++ = {view.orientations, 3 * view.n_sites};
    *arrays++ = {view.orbits, view.n_sites};
    phases = listed(view.phase_names, view.n_phases);
    *names = phases.c_str();
    return PCVT_OK;
}

/// @param names  becomes the names of the holes, with commas.
EMSCRIPTEN_KEEPALIVE int view_tile(const Run* run, int kind, int outline, Array* arrays,
                                   const char** names) {
    static pcvt_tile view;
    static std::string holes;
    const pcvt_status status = pcvt_get_tile(run->result, kind, outline, &view, sizeof view);
    if (status != PCVT_OK) return status;
    *arrays++ = {view.lattice, 4};
    *arrays++ = {view.points, 2 * view.n_vertices};
    *arrays++ = {view.face_begin, view.n_faces + 1};
    *arrays++ = {view.corners, view.n_corners};
    *arrays++ = {view.face_site, view.n_faces};
    *arrays++ = {view.site_points, 2 * view.n_faces};
    *arrays++ = {view.vertex_site, view.n_vertices};
    *arrays++ = {view.vertex_orbit, view.n_vertices};
    *arrays++ = {view.vertex_offset, 2 * view.n_vertices};
    static_assert(sizeof(pcvt_edge_pair) == 6 * sizeof(std::int32_t));
    *arrays++ = {view.edge_pairs, 6 * view.n_edge_pairs};
    static_assert(sizeof(pcvt_wall_edge) == 3 * sizeof(std::int32_t));
    *arrays++ = {view.wall_edges, 3 * view.n_wall_edges};
    holes = listed(view.hole_names, view.n_holes);
    *names = holes.c_str();
    return PCVT_OK;
}

EMSCRIPTEN_KEEPALIVE int view_mesh(const Run* run, int kind, Array* arrays) {
    static pcvt_mesh view;
    const pcvt_status status = pcvt_get_mesh(run->result, kind, &view, sizeof view);
    if (status != PCVT_OK) return status;
    *arrays++ = {view.lattice, 4};
    *arrays++ = {view.vertices, 2 * view.n_vertices};
    *arrays++ = {view.face_begin, view.n_faces + 1};
    *arrays++ = {view.corner_vertex, view.n_corners};
    *arrays++ = {view.corner_offset, 2 * view.n_corners};
    *arrays++ = {view.opposite, view.n_corners};
    *arrays++ = {view.site, kind == PCVT_VORONOI ? view.n_faces : view.n_vertices};
    *arrays++ = {view.site_points, 2 * view.n_faces};
    return PCVT_OK;
}

/// Gives the arrays of a result in space. @param n_inner_faces  is set as well.
EMSCRIPTEN_KEEPALIVE int view_cells(const Run* run, Array* arrays, std::int32_t* n_inner_faces) {
    static pcvt_cells view;
    const pcvt_status status = pcvt_get_cells(run->result, &view, sizeof view);
    if (status != PCVT_OK) return status;
    const std::int32_t n_boundary = view.n_faces - view.n_inner_faces;
    *arrays++ = {view.lattice, 9};
    *arrays++ = {view.points, 3 * view.n_points};
    *arrays++ = {view.point_orbit, view.n_points};
    *arrays++ = {view.point_offset, 3 * view.n_points};
    *arrays++ = {view.face_begin, view.n_faces + 1};
    *arrays++ = {view.face_points, view.n_face_points};
    *arrays++ = {view.owner, view.n_faces};
    *arrays++ = {view.neighbour, view.n_faces};
    *arrays++ = {view.partner, n_boundary};
    *arrays++ = {view.partner_offset, 3 * n_boundary};
    *arrays++ = {view.volumes, view.n_cells};
    *arrays++ = {view.site_points, 3 * view.n_cells};
    *n_inner_faces = view.n_inner_faces;
    return PCVT_OK;
}

}  // extern "C"

}  // namespace pcvt::browser
