#include "plugin/meshlab/tile_layer.hpp"

#include <vcg/complex/algorithms/update/bounding.h>

#include <algorithm>
#include <utility>

namespace pcvt::meshlab {
namespace {

using Edge = std::pair<int32_t, int32_t>;

const vcg::Point3f kUp(0, 0, 1);

void add_vertices(CMeshO& mesh, const pcvt_tile& tile) {
    vcg::tri::Allocator<CMeshO>::AddVertices(mesh, tile.n_vertices);
    const int32_t* quality = tile.vertex_site ? tile.vertex_site : tile.vertex_orbit;
    for (int v = 0; v < tile.n_vertices; ++v) {
        const double* point = tile.points + 2 * v;
        mesh.vert[v].P() =
            vcg::Point3f(static_cast<float>(point[0]), static_cast<float>(point[1]), 0);
        mesh.vert[v].N() = kUp;
        mesh.vert[v].Q() = static_cast<float>(quality[v]);
        mesh.vert[v].C() = vcg::Color4b::White;
    }
}

int count_triangles(const pcvt_tile& tile) { return tile.n_corners - 2 * tile.n_faces; }

/// The first triangle of face f: every face before it has two triangles less than corners.
int first_triangle(const pcvt_tile& tile, int f) { return tile.face_begin[f] - 2 * f; }

void add_fan(CMeshO& mesh, const pcvt_tile& tile, int f) {
    const int32_t* corners = tile.corners + tile.face_begin[f];
    const int first = first_triangle(tile, f);
    const int n = first_triangle(tile, f + 1) - first;
    for (int k = 0; k < n; ++k) {
        CFaceO& triangle = mesh.face[first + k];
        const int32_t ends[] = {corners[0], corners[k + 1], corners[k + 2]};
        for (int c = 0; c < 3; ++c) triangle.V(c) = &mesh.vert[ends[c]];
        if (k > 0) triangle.SetF(0);
        if (k + 1 < n) triangle.SetF(2);
        triangle.N() = kUp;
    }
}

void add_faces(CMeshO& mesh, const pcvt_tile& tile) {
    vcg::tri::Allocator<CMeshO>::AddFaces(mesh, count_triangles(tile));
    for (int f = 0; f < tile.n_faces; ++f) add_fan(mesh, tile, f);
}

/// Calls change(triangle, f) for each triangle of each face f.
template <class Change>
void for_each_triangle(CMeshO& mesh, const pcvt_tile& tile, const Change& change) {
    for (int f = 0; f < tile.n_faces; ++f) {
        for (int t = first_triangle(tile, f); t < first_triangle(tile, f + 1); ++t) {
            change(mesh.face[t], f);
        }
    }
}

void colour(CMeshO& mesh, const pcvt_tile& tile, const std::vector<vcg::Color4b>& colours) {
    if (tile.vertex_site) {
        for (int v = 0; v < tile.n_vertices; ++v) {
            mesh.vert[v].C() = colours[tile.vertex_site[v]];
        }
    } else {
        for_each_triangle(mesh, tile, [&](CFaceO& triangle, int f) {
            triangle.C() = colours[tile.face_site[f]];
        });
    }
}

/// The boundary edges, directed with their face on the left, in order.
std::vector<Edge> seam_edges(const pcvt_tile& tile) {
    std::vector<Edge> edges;
    for (int k = 0; k < tile.n_edge_pairs; ++k) {
        const pcvt_edge_pair& pair = tile.edge_pairs[k];
        edges.emplace_back(pair.v0, pair.v1);
        edges.emplace_back(pair.w1, pair.w0);
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

std::vector<char> faces_at(const std::vector<Edge>& edges, const pcvt_tile& tile) {
    std::vector<char> touched(tile.n_faces, 0);
    for (int f = 0; f < tile.n_faces; ++f) {
        const int begin = tile.face_begin[f];
        const int end = tile.face_begin[f + 1];
        for (int c = begin; c < end; ++c) {
            const Edge edge{tile.corners[c], tile.corners[c + 1 < end ? c + 1 : begin]};
            touched[f] |= std::binary_search(edges.begin(), edges.end(), edge);
        }
    }
    return touched;
}

void select_seam(CMeshO& mesh, const pcvt_tile& tile, const TileRequest& request) {
    const std::vector<Edge> edges = seam_edges(tile);
    if (request.select_vertices) {
        for (const auto& [from, to] : edges) mesh.vert[from].SetS();
    }
    if (request.select_faces) {
        const std::vector<char> touched = faces_at(edges, tile);
        for_each_triangle(mesh, tile, [&](CFaceO& triangle, int f) {
            if (touched[f]) triangle.SetS();
        });
    }
}

}  // namespace

void fill_layer(MeshModel& layer, const pcvt_tile& tile, const std::vector<vcg::Color4b>& colours,
                const TileRequest& request) {
    CMeshO& mesh = layer.cm;
    layer.updateDataMask(MeshModel::MM_VERTQUALITY);
    if (tile.kind != PCVT_DELAUNAY) {
        layer.updateDataMask(MeshModel::MM_FACEQUALITY | MeshModel::MM_POLYGONAL);
    }
    add_vertices(mesh, tile);
    add_faces(mesh, tile);
    if (tile.face_site) {
        for_each_triangle(mesh, tile, [&](CFaceO& triangle, int f) {
            triangle.Q() = static_cast<float>(tile.face_site[f]);
        });
    }
    if (!colours.empty()) {
        layer.updateDataMask(tile.vertex_site ? MeshModel::MM_VERTCOLOR : MeshModel::MM_FACECOLOR);
        colour(mesh, tile, colours);
    }
    select_seam(mesh, tile, request);
    vcg::tri::UpdateBounding<CMeshO>::Box(mesh);
}

}  // namespace pcvt::meshlab
