#include "mesher/space/mesh/shrunk_face.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "mesher/portable/portable_angles.hpp"

namespace pcvt::space {

Corners shrunk(Corners corners, const ShortEdge& edge) {
    for (VertexImage& corner : corners) {
        if (corner.vertex == edge.to.vertex) {
            corner = {edge.from, corner.offset - edge.to.offset};
        }
    }
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    return corners;
}

double sharpest_corner(const Corners& corners,
                       const std::function<Vec3(const VertexImage&)>& position) {
    const std::size_t n = corners.size();
    double sharpest = 180;
    for (std::size_t k = 0; k < n; ++k) {
        const Vec3 here = position(corners[k]);
        const Vec3 ahead = position(corners[(k + 1) % n]) - here;
        const Vec3 behind = position(corners[(k + n - 1) % n]) - here;
        const double angle = portable_atan2(ahead.cross(behind).norm(), ahead.dot(behind));
        sharpest = std::min(sharpest, angle * 180 / std::numbers::pi);
    }
    return sharpest;
}

}  // namespace pcvt::space
