#include "mesher/space/grains/cell_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

/// An edge of a face, turned so that it runs from the smaller image to the larger one.
struct FaceEdge {
    int from;
    int to;
    Offset step;
    /// Its number among CellComplex::corners.
    int corner;
    int face;
    Offset offset;
    bool reversed;

    auto key() const { return std::tie(from, to, step, corner); }
    bool is_image_of(const FaceEdge& other) const {
        return from == other.from && to == other.to && step == other.step;
    }
};

std::vector<FaceEdge> face_edges(const CellComplex& complex) {
    std::vector<FaceEdge> edges;
    for (int f = 0; f < complex.n_faces(); ++f) {
        const std::span<const VertexImage> corners = complex.corners_of(f);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            VertexImage from = corners[k];
            VertexImage to = corners[(k + 1) % corners.size()];
            const Offset step = to.offset - from.offset;
            const bool reversed =
                to.vertex < from.vertex || (to.vertex == from.vertex && step < Offset{});
            if (reversed) std::swap(from, to);
            edges.push_back({from.vertex, to.vertex, to.offset - from.offset,
                             complex.begin[f] + static_cast<int>(k), f, from.offset, reversed});
        }
    }
    std::sort(edges.begin(), edges.end(),
              [](const FaceEdge& e, const FaceEdge& g) { return e.key() < g.key(); });
    return edges;
}

/// The distance of x from the segment between a and b.
double distance_to_segment(const Vec3& x, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double u = std::clamp(dot_product(x - a, ab) / squared_length(ab), 0.0, 1.0);
    return distance(x, a + u * ab);
}

void lower(double& size, double other) { size = std::min(size, other); }

std::vector<double> vertex_sizes(const CellComplex& complex, const std::vector<double>& face_size) {
    std::vector<double> sizes(complex.vertices.size(),
                              *std::max_element(face_size.begin(), face_size.end()));
    std::vector<Vec3> at;
    for (int f = 0; f < complex.n_faces(); ++f) {
        checkpoint_each(f);
        const std::span<const VertexImage> corners = complex.corners_of(f);
        const std::size_t n = corners.size();
        at.clear();
        for (const VertexImage& corner : corners) at.push_back(complex.position(corner));
        for (std::size_t i = 0; i < n; ++i) {
            double& size = sizes[corners[i].vertex];
            lower(size, face_size[f]);
            lower(size, distance(at[i], at[(i + 1) % n]));
            lower(sizes[corners[(i + 1) % n].vertex], distance(at[i], at[(i + 1) % n]));
            for (std::size_t k = i + 1; k < i + n - 1; ++k) {
                lower(size, distance_to_segment(at[i], at[k % n], at[(k + 1) % n]));
            }
        }
    }
    return sizes;
}

/// Divides an edge into round(integral of 1 / size) parts with equal integrals.
void divide(const CellComplex& complex, const std::vector<double>& vertex_size, CellEdge& edge) {
    constexpr int kSteps = 256;
    const double whole = distance(complex.position(edge.from), complex.position(edge.to));
    std::array<double, kSteps + 1> integral{};
    for (int k = 0; k < kSteps; ++k) {
        const double x = (k + 0.5) / kSteps * whole;
        const double size = std::min({edge.size, vertex_size[edge.from.vertex] + kSizeGrowth * x,
                                      vertex_size[edge.to.vertex] + kSizeGrowth * (whole - x)});
        integral[k + 1] = integral[k] + whole / kSteps / size;
    }
    const long n_parts = std::max(1L, std::lround(integral[kSteps]));
    int k = 0;
    for (long part = 1; part < n_parts; ++part) {
        const double target =
            integral[kSteps] * static_cast<double>(part) / static_cast<double>(n_parts);
        while (integral[k + 1] < target) ++k;
        const double within = (target - integral[k]) / (integral[k + 1] - integral[k]);
        edge.cuts.push_back((k + within) / kSteps);
    }
}

}  // namespace

CellEdges cell_edges(const CellComplex& complex, const std::vector<double>& cell_size) {
    std::vector<double> face_size;
    for (const CellFace& face : complex.faces) {
        face_size.push_back(std::min(cell_size[face.cell], cell_size[face.neighbour]));
    }
    CellEdges all;
    all.uses.resize(complex.corners.size());
    const std::vector<FaceEdge> edges = face_edges(complex);
    for (std::size_t k = 0; k < edges.size(); ++k) {
        const FaceEdge& e = edges[k];
        if (k == 0 || !e.is_image_of(edges[k - 1])) {
            all.edges.push_back({{e.from, {}}, {e.to, e.step}, face_size[e.face]});
        }
        CellEdge& edge = all.edges.back();
        lower(edge.size, face_size[e.face]);
        edge.faces.push_back(e.face);
        all.uses[e.corner] = {static_cast<int>(all.edges.size()) - 1, e.offset, e.reversed};
    }
    all.vertex_size = vertex_sizes(complex, face_size);
    for (CellEdge& edge : all.edges) divide(complex, all.vertex_size, edge);
    return all;
}

}  // namespace pcvt::space
