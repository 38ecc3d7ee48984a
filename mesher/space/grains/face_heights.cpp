#include "mesher/space/grains/face_heights.hpp"

#include <cmath>
#include <optional>

#include "mesher/space/grains/ear_cutting.hpp"
#include "mesher/space/grains/tetrahedron_shape.hpp"

namespace pcvt::space {
namespace {

/// A point of the boundary of a face, in its plane and above it.
struct BoundaryPoint {
    Point2 at;
    double height;
};

class FaceHeights {
   public:
    FaceHeights(const CellComplex& complex, const GrainSurface& surface, int face)
        : plane_(face_plane(complex, face)) {
        for (int c = complex.begin[face]; c < complex.begin[face + 1]; ++c) {
            add(complex.position(complex.corners[c]));
            const EdgeUse& use = surface.edges.uses[c];
            const std::vector<int>& nodes = surface.edge_nodes[use.edge];
            const int n = static_cast<int>(nodes.size());
            for (int k = 0; k < n; ++k) {
                add(surface.position(complex, {nodes[use.reversed ? n - 1 - k : k], use.offset}));
            }
        }
    }

    Vec3 smooth(const Vec3& p) const {
        const Point2 at = in_plane(p);
        return plane_.origin + at.x() * plane_.x + at.y() * plane_.y +
               height_at(at) * plane_.normal;
    }

   private:
    Point2 in_plane(const Vec3& p) const {
        return {dot_product(p - plane_.origin, plane_.x), dot_product(p - plane_.origin, plane_.y)};
    }
    void add(const Vec3& p) {
        boundary_.push_back({in_plane(p), dot_product(p - plane_.origin, plane_.normal)});
    }

    /// The tangent of half the angle between two vectors.
    static double half_tangent(const Point2& a, const Point2& b) {
        const double lengths = std::sqrt(square(a) * square(b));
        const double along = dot2(a, b);
        const double across = cross2(a, b);
        return along > 0 ? across / (lengths + along) : (lengths - along) / across;
    }

    double height_at(const Point2& at) const {
        double weights = 0;
        double sum = 0;
        const std::size_t n = boundary_.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Point2 arm = boundary_[k].at - at;
            const double tangents = half_tangent(boundary_[(k + n - 1) % n].at - at, arm) +
                                    half_tangent(arm, boundary_[(k + 1) % n].at - at);
            const double weight = tangents / std::sqrt(square(arm));
            weights += weight;
            sum += weight * boundary_[k].height;
        }
        return sum / weights;
    }

    FacePlane plane_;
    std::vector<BoundaryPoint> boundary_;
};

}  // namespace

void smooth_heights(const CellComplex& complex, const std::vector<int>& faces,
                    GrainSurface& surface) {
    std::vector<char> is_chosen(complex.faces.size(), 0);
    for (const int f : faces) is_chosen[f] = 1;
    int last = -1;
    std::optional<FaceHeights> heights;
    // The nodes of a face follow each other.
    for (SurfaceNode& node : surface.nodes) {
        if (node.dimension != 2 || is_chosen[node.carrier] == 0) continue;
        if (node.carrier != last) heights.emplace(complex, surface, node.carrier);
        last = node.carrier;
        node.position = heights->smooth(node.position);
    }
}

}  // namespace pcvt::space
