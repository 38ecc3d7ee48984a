#include "mesher/space/box/plane_levels.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "mesher/space/mesh/vector_area.hpp"

namespace pcvt::space {
namespace {

/// An edge or a face that keeps less than this part of its length or area almost vanishes.
constexpr double kVanishes = 0.5;
/// A shorter edge, over the distance of snapping, keeps both of its ends where only one is near to
/// a plane.
constexpr double kShortEdge = 2;

/// The distances within which vertices are snapped.
class Snapping {
   public:
    Snapping(const AxisPlanes& planes, const Nearness& near, const CellComplex& complex)
        : near_(near), complex_(complex), is_held_(complex.vertices.size(), 0) {
        for (const Vec3& vertex : complex.vertices) {
            const int plane = static_cast<int>(std::round(planes.height(vertex)));
            const bool is_near = planes.distance(plane, vertex) <= near.snapped;
            is_near_.push_back(is_near ? 1 : 0);
            ways_.emplace_back(Vec3::Zero());
            if (!is_near) continue;
            Vec3 snapped = vertex;
            planes.put_on(plane, snapped);
            ways_.back() = snapped - vertex;
        }
    }

    /// For each vertex how near to a plane it lies on it.
    std::vector<double> distances() {
        std::vector<double> distances(is_near_.size(), kEdgeOverSnap * near_.snapped);
        for (int f = 0; f < complex_.n_faces(); ++f) {
            const std::span<const VertexImage> corners = complex_.corners_of(f);
            visit_face(corners);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const VertexImage& a = corners[k];
                const VertexImage& b = corners[(k + 1) % corners.size()];
                const double length = (complex_.position(b) - complex_.position(a)).norm();
                visit_edge(a, b, length);
                for (const int v : {a.vertex, b.vertex}) {
                    distances[v] = std::min(distances[v], length);
                }
            }
        }
        for (std::size_t v = 0; v < distances.size(); ++v) {
            distances[v] = is_held_[v] == 0 ? near_.snapped
                                            : std::max(near_.all, distances[v] / kEdgeOverSnap);
        }
        return distances;
    }

   private:
    Vec3 snapped(const VertexImage& corner) const {
        return complex_.position(corner) + ways_[corner.vertex];
    }

    void visit_edge(const VertexImage& a, const VertexImage& b, double length) {
        if (length >= kEdgeOverSnap * near_.snapped) return;
        const bool one_is_near = is_near_[a.vertex] != is_near_[b.vertex];
        const bool keeps_both = one_is_near && length < kShortEdge * near_.snapped;
        if (keeps_both || (snapped(b) - snapped(a)).norm() < kVanishes * length) {
            is_held_[a.vertex] = is_held_[b.vertex] = 1;
        }
    }

    void visit_face(std::span<const VertexImage> corners) {
        const auto is_near = [&](const VertexImage& v) { return is_near_[v.vertex] != 0; };
        if (!std::all_of(corners.begin(), corners.end(), is_near)) return;
        const Vec3 before = twice_vector_area(
            corners, [&](const VertexImage& corner) { return complex_.position(corner); });
        const Vec3 after =
            twice_vector_area(corners, [&](const VertexImage& corner) { return snapped(corner); });
        if (after.dot(before) >= kVanishes * before.squaredNorm()) return;
        for (const VertexImage& corner : corners) is_held_[corner.vertex] = 1;
    }

    const Nearness& near_;
    const CellComplex& complex_;
    /// Whether a vertex is near enough to be snapped, and its way there.
    std::vector<char> is_near_;
    std::vector<Vec3> ways_;
    /// The vertices of what would vanish.
    std::vector<char> is_held_;
};

}  // namespace

Vec3 upwards(const Lattice& lattice, int axis) {
    const auto& periods = lattice.periods();
    const Vec3 normal = periods[(axis + 1) % 3].cross(periods[(axis + 2) % 3]);
    return lattice.right_handed() ? normal : Vec3(-normal);
}

std::vector<int> put_on_planes(const AxisPlanes& planes, const Nearness& near,
                               CellComplex& complex) {
    const std::vector<double> distances =
        near.snapped > 0 ? Snapping(planes, near, complex).distances()
                         : std::vector<double>(complex.vertices.size(), near.all);
    std::vector<int> levels;
    for (std::size_t v = 0; v < complex.vertices.size(); ++v) {
        const double u = planes.height(complex.vertices[v]);
        const int plane = static_cast<int>(std::round(u));
        const bool is_on = std::abs(u - plane) <= distances[v] / planes.spacing();
        if (is_on) planes.put_on(plane, complex.vertices[v]);
        levels.push_back(is_on ? 2 * plane : 2 * static_cast<int>(std::floor(u)) + 1);
    }
    return levels;
}

}  // namespace pcvt::space
