#include "plugin/meshlab/tile_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace pcvt::meshlab {
namespace {

/// Edges shorter than this, in units of h, do not count as sides.
constexpr double kShortEdge = 1e-5;
constexpr int kFewest = 3;

/// From three sides to nine.
vcg::Color4b side_colour(int sides) {
    static const std::array<vcg::Color4b, 7> kBySides{
        vcg::Color4b(0x14, 0x21, 0x5c, 255), vcg::Color4b(0x25, 0x5f, 0xb0, 255),
        vcg::Color4b(0x62, 0xb0, 0xdf, 255), vcg::Color4b(0xf3, 0xef, 0xe4, 255),
        vcg::Color4b(0xf2, 0xa2, 0x3c, 255), vcg::Color4b(0xcb, 0x4b, 0x1e, 255),
        vcg::Color4b(0x70, 0x15, 0x18, 255)};
    const int last = kFewest + static_cast<int>(kBySides.size()) - 1;
    return kBySides[std::clamp(sides, kFewest, last) - kFewest];
}

pcvt_mesh periodic_mesh(const pcvt_result* result, int32_t kind) {
    pcvt_mesh mesh;
    if (pcvt_get_mesh(result, kind, &mesh, sizeof mesh) != PCVT_OK) {
        throw std::runtime_error(pcvt_last_error());
    }
    return mesh;
}

std::array<double, 2> corner_point(const pcvt_mesh& cells, int corner) {
    const double* vertex = cells.vertices + 2 * cells.corner_vertex[corner];
    const int32_t* offset = cells.corner_offset + 2 * corner;
    const double* lattice = cells.lattice;
    return {vertex[0] + offset[0] * lattice[0] + offset[1] * lattice[2],
            vertex[1] + offset[0] * lattice[1] + offset[1] * lattice[3]};
}

/// The sides of each site's cell.
std::vector<int> sides_of_cells(const pcvt_mesh& cells, double short_edges) {
    const double* l = cells.lattice;
    const double h = std::sqrt(std::abs(l[0] * l[3] - l[1] * l[2]) / cells.n_faces);
    std::vector<int> sides(cells.n_faces, 0);
    for (int f = 0; f < cells.n_faces; ++f) {
        const int begin = cells.face_begin[f];
        const int end = cells.face_begin[f + 1];
        for (int c = begin; c < end; ++c) {
            const auto p = corner_point(cells, c);
            const auto q = corner_point(cells, c + 1 < end ? c + 1 : begin);
            sides[cells.site[f]] += std::hypot(q[0] - p[0], q[1] - p[1]) > short_edges * h;
        }
    }
    return sides;
}

/// The triangles round each site.
std::vector<int> valences_of_sites(const pcvt_mesh& triangles) {
    std::vector<int> valences(triangles.n_vertices, 0);
    for (int c = 0; c < triangles.n_corners; ++c) {
        ++valences[triangles.site[triangles.corner_vertex[c]]];
    }
    return valences;
}

std::vector<vcg::Color4b> scattered_colours(int n) {
    std::vector<vcg::Color4b> colours;
    for (int site = 0; site < n; ++site) {
        colours.push_back(vcg::Color4b::Scatter(n, site, 0.5F, 0.9F));
    }
    return colours;
}

}  // namespace

std::vector<vcg::Color4b> site_colours(const pcvt_result* result, const TileRequest& request) {
    if (request.colouring == Colouring::kNone) return {};
    if (request.colouring == Colouring::kByCell) return scattered_colours(request.options.n_sites);
    const std::vector<int> sides =
        request.kind == PCVT_DELAUNAY
            ? valences_of_sites(periodic_mesh(result, PCVT_DELAUNAY))
            : sides_of_cells(periodic_mesh(result, PCVT_VORONOI),
                             std::max(kShortEdge, request.options.short_edges));
    std::vector<vcg::Color4b> colours;
    for (const int n : sides) colours.push_back(side_colour(n));
    return colours;
}

}  // namespace pcvt::meshlab
