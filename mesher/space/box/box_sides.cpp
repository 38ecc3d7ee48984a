#include "mesher/space/box/box_sides.hpp"

#include <array>
#include <vector>

namespace pcvt::space {
namespace {

using Axes = std::array<bool, 3>;

/// The coordinate that is constant on the sides across a period vector; -1 if there is none.
int constant_coordinate(const Lattice& lattice, int axis) {
    const Vec3& p = lattice.periods()[(axis + 1) % 3];
    const Vec3& q = lattice.periods()[(axis + 2) % 3];
    for (int d = 0; d < 3; ++d) {
        if (p[d] == 0 && q[d] == 0) return d;
    }
    return -1;
}

class BoxSides {
   public:
    BoxSides(const Lattice& lattice, const Vec3& origin) : lattice_(lattice), origin_(origin) {
        for (int axis = 0; axis < 3; ++axis) constant_[axis] = constant_coordinate(lattice, axis);
    }

    /// Moves a point to the lower sides across these axes.
    Vec3 put_on(const Axes& axes, Vec3 p) const {
        if (axes == Axes{true, true, true}) return origin_;
        for (int axis = 0; axis < 3; ++axis) {
            if (!axes[axis] || constant_[axis] >= 0) continue;
            p -= lattice_.to_lattice(p - origin_)[axis] * lattice_.periods()[axis];
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (axes[axis] && constant_[axis] >= 0) p[constant_[axis]] = origin_[constant_[axis]];
        }
        return p;
    }

    /// @param first    for each point the number of the first one of its orbit.
    /// @param offset   of each point from that one.
    void put_on(const std::vector<int>& first, const std::vector<Offset>& offset,
                std::vector<Vec3>& points) const {
        // Points on a side have an image on the opposite one.
        std::vector<Axes> axes(points.size(), Axes{});
        for (std::size_t p = 0; p < points.size(); ++p) {
            const std::array<int, 3> o = offset[p].components();
            for (int axis = 0; axis < 3; ++axis) axes[first[p]][axis] |= o[axis] != 0;
        }
        for (std::size_t p = 0; p < points.size(); ++p) {
            if (first[p] == static_cast<int>(p)) {
                points[p] = put_on(axes[p], points[p]);
            } else {
                points[p] = points[first[p]] + lattice_.translation(offset[p]);
            }
        }
    }

   private:
    const Lattice& lattice_;
    const Vec3& origin_;
    std::array<int, 3> constant_{};
};

}  // namespace

void put_on_sides(const Vec3& origin, PolyhedralMesh& mesh) {
    BoxSides(mesh.lattice, origin).put_on(mesh.point_orbit, mesh.point_offset, mesh.points);
}

void put_on_sides(const Vec3& origin, TetrahedralMesh& mesh) {
    std::vector<int> first_of_node;
    std::vector<int> first;
    for (int p = 0; p < mesh.n_points(); ++p) {
        const auto node = static_cast<std::size_t>(mesh.point_site[p]);
        if (first_of_node.size() <= node) first_of_node.resize(node + 1, -1);
        if (first_of_node[node] < 0) first_of_node[node] = p;
        first.push_back(first_of_node[node]);
    }
    BoxSides(mesh.lattice, origin).put_on(first, mesh.point_offset, mesh.points);
}

}  // namespace pcvt::space
