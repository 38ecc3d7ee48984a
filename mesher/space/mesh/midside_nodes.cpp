#include "mesher/space/mesh/midside_nodes.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "mesher/base/cancellable_sort.hpp"

namespace pcvt::space {
namespace {

/// An edge of the tile under the same name from each of its tetrahedra.
struct TileEdge {
    int low;
    int high;
    /// 6 t + k for edge k of tetrahedron t.
    int place;

    bool is_same(const TileEdge& other) const { return low == other.low && high == other.high; }
};

/// An edge and its images under the same name: its ends, the first of which has the offset 0.
struct EdgeImage {
    SiteId first;
    SiteId second;
    Offset relative;
    int node;
    Offset offset;

    auto orbit() const { return std::tie(first, second, relative); }
};

std::vector<TileEdge> sorted_edges(const TetrahedralMesh& mesh) {
    std::vector<TileEdge> edges;
    edges.reserve(kEdgeCorners.size() * mesh.tetrahedra.size());
    int place = 0;
    for (const std::array<int, 4>& corners : mesh.tetrahedra) {
        for (const auto& [i, j] : kEdgeCorners) {
            const auto [low, high] = std::minmax(corners[i], corners[j]);
            edges.push_back({low, high, place++});
        }
    }
    cancellable_sort(edges.begin(), edges.end(), [](const TileEdge& s, const TileEdge& t) {
        return std::tie(s.low, s.high, s.place) < std::tie(t.low, t.high, t.place);
    });
    return edges;
}

/// Numbers the edges in the order of the tetrahedra; returns the ends of each.
std::vector<std::pair<int, int>> numbered_edges(const TetrahedralMesh& mesh, MidsideNodes& nodes) {
    const std::vector<TileEdge> edges = sorted_edges(mesh);
    // For each place the first one on the same edge.
    std::vector<int> first(edges.size());
    for (std::size_t k = 0; k < edges.size(); ++k) {
        const bool again = k > 0 && edges[k].is_same(edges[k - 1]);
        first[edges[k].place] = again ? first[edges[k - 1].place] : edges[k].place;
    }
    nodes.of_tetrahedron.resize(mesh.tetrahedra.size());
    std::vector<std::pair<int, int>> ends;
    for (std::size_t place = 0; place < first.size(); ++place) {
        const auto of = static_cast<std::size_t>(first[place]);
        int& node = nodes.of_tetrahedron[place / 6][place % 6];
        if (of < place) {
            node = nodes.of_tetrahedron[of / 6][of % 6];
            continue;
        }
        node = mesh.n_points() + static_cast<int>(ends.size());
        const auto& [i, j] = kEdgeCorners[place % 6];
        const std::array<int, 4>& corners = mesh.tetrahedra[place / 6];
        ends.emplace_back(std::minmax(corners[i], corners[j]));
    }
    return ends;
}

EdgeImage edge_image(const TetrahedralMesh& mesh, int v, int w, int node) {
    Corner first = mesh.corner(v);
    Corner second = mesh.corner(w);
    if (second < first) std::swap(first, second);
    return {.first = first.site,
            .second = second.site,
            .relative = second.offset - first.offset,
            .node = node,
            .offset = first.offset};
}

}  // namespace

MidsideNodes midside_nodes(const TetrahedralMesh& mesh) {
    MidsideNodes nodes;
    const std::vector<std::pair<int, int>> ends = numbered_edges(mesh, nodes);
    std::vector<EdgeImage> images;
    images.reserve(ends.size());
    for (const auto& [v, w] : ends) {
        images.push_back(edge_image(mesh, v, w, mesh.n_points() + static_cast<int>(images.size())));
        nodes.points.push_back(mesh.points[v] + (mesh.points[w] - mesh.points[v]) / 2);
    }
    cancellable_sort(images.begin(), images.end(), [](const EdgeImage& s, const EdgeImage& t) {
        return std::tuple(s.orbit(), s.node) < std::tuple(t.orbit(), t.node);
    });
    nodes.orbit.resize(images.size());
    nodes.offset.resize(images.size());
    const EdgeImage* representative = nullptr;
    for (const EdgeImage& image : images) {
        if (representative == nullptr || representative->orbit() != image.orbit()) {
            representative = &image;
        }
        const int k = image.node - mesh.n_points();
        nodes.orbit[k] = representative->node;
        nodes.offset[k] = image.offset - representative->offset;
        nodes.points[k] = nodes.points[representative->node - mesh.n_points()] +
                          mesh.lattice.translation(nodes.offset[k]);
    }
    return nodes;
}

TetrahedralMesh of_order(int order, TetrahedralMesh mesh) {
    mesh.order = order;
    return mesh;
}

}  // namespace pcvt::space
