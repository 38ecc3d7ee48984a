#include "mesher/space/proof/box_proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace pcvt::space {
namespace {

/// Roundings of a position on its way to a lattice coordinate, in tolerances of positions.
constexpr double kCoordinateRoundings = 8;

/// Collects the points of lower sides of a box.
class LowerSides {
   public:
    explicit LowerSides(const Lattice& lattice) : lattice_(lattice) {}

    /// Adds a face, which becomes its partner by the translation of `offset`; a box has only those
    /// by one period.
    void add(std::span<const int> corners, const Offset& offset, const std::vector<Vec3>& points) {
        const std::array<int, 3> o = offset.components();
        for (int axis = 0; axis < 3; ++axis) {
            if (o[axis] != 1) continue;
            is_box_ &= o[(axis + 1) % 3] == 0 && o[(axis + 2) % 3] == 0;
            for (const int v : corners) {
                const double u = lattice_.to_lattice(points[v])[axis];
                least_[axis] = std::min(least_[axis], u);
                largest_[axis] = std::max(largest_[axis], u);
            }
            return;
        }
        is_box_ = false;
    }

    /// @returns the point in the corner of the lower sides.
    std::optional<Vec3> corner(double tolerance, const std::vector<Vec3>& points) const {
        const Vec3 heights = lattice_.heights();
        for (int axis = 0; axis < 3; ++axis) {
            const double thickness = (largest_[axis] - least_[axis]) * heights[axis];
            // No face is left as minus infinity.
            if (!is_box_ || !(std::abs(thickness) <= kCoordinateRoundings * tolerance)) return {};
        }
        const Vec3 near = lattice_.to_position(least_);
        return *std::min_element(points.begin(), points.end(), [&](const Vec3& p, const Vec3& q) {
            return (p - near).squaredNorm() < (q - near).squaredNorm();
        });
    }

   private:
    const Lattice& lattice_;
    Vec3 least_ = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 largest_ = -least_;
    bool is_box_ = true;
};

}  // namespace

std::optional<Vec3> box_corner(const PolyhedralMesh& mesh, double tolerance) {
    LowerSides sides(mesh.lattice);
    for (const FiniteVolumePatch& patch : mesh.patches) {
        const Offset offset = patch.offset_as<Offset>();
        if (offset < Offset{}) continue;
        for (int k = 0; k < patch.n_faces; ++k) {
            sides.add(mesh.faces[patch.first_face + k], offset, mesh.points);
        }
    }
    return sides.corner(tolerance, mesh.points);
}

std::optional<Vec3> box_corner(const TetrahedralMesh& mesh, const TetrahedralProof& proof) {
    LowerSides sides(mesh.lattice);
    for (const TrianglePair& pair : proof.pairs) sides.add(pair.first, pair.offset, mesh.points);
    return sides.corner(proof.tolerance, mesh.points);
}

}  // namespace pcvt::space
