#include "mesher/space/grains/cell_edges.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"
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

/// The target size along an edge: it rises from those at both ends by kSizeGrowth, up to the size
/// of the edge. Distances are from the first end, length units.
class SizeAlong {
   public:
    SizeAlong(double length, double first, double last, double largest)
        : length_(length),
          first_(first),
          last_(last),
          top_(std::min({largest, (first + last + kSizeGrowth * length) / 2,
                         first + kSizeGrowth * length, last + kSizeGrowth * length})),
          rise_(std::max(0.0, top_ - first) / kSizeGrowth),
          flat_(std::max(0.0, length - rise_ - std::max(0.0, top_ - last) / kSizeGrowth)),
          to_rise_(rise_ > 0 ? portable_log(top_ / first) / kSizeGrowth : 0),
          to_flat_(to_rise_ + flat_ / top_),
          whole_(to_flat_ + (top_ > last ? portable_log(top_ / last) / kSizeGrowth : 0)) {}

    /// The integral of 1 / size over the whole edge.
    double whole() const { return whole_; }
    /// The distance up to which the integral has a value.
    double distance_of(double integral) const {
        if (integral < to_rise_) return grown(first_, integral);
        if (integral < to_flat_) return rise_ + (integral - to_rise_) * top_;
        return length_ - grown(last_, whole_ - integral);
    }

   private:
    /// The distance from an end over which the integral grows from 0 to a value.
    static double grown(double size, double integral) {
        return size * (portable_exp(kSizeGrowth * integral) - 1) / kSizeGrowth;
    }

    double length_;
    double first_;
    double last_;
    /// The largest size.
    double top_;
    /// The lengths over which the size rises and remains the same.
    double rise_;
    double flat_;
    /// The integrals up to their ends.
    double to_rise_;
    double to_flat_;
    double whole_;
};

/// Divides an edge into round(integral of 1 / size) parts with equal integrals.
void divide(const CellComplex& complex, const std::vector<double>& vertex_size, CellEdge& edge) {
    const double length = distance(complex.position(edge.from), complex.position(edge.to));
    const SizeAlong size(length, vertex_size[edge.from.vertex], vertex_size[edge.to.vertex],
                         edge.size);
    const long n_parts = std::max(1L, std::lround(size.whole()));
    for (long part = 1; part < n_parts; ++part) {
        const double integral =
            size.whole() * (static_cast<double>(part) / static_cast<double>(n_parts));
        edge.cuts.push_back(size.distance_of(integral) / length);
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
