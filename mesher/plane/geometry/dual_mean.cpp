#include "mesher/plane/geometry/dual_mean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "mesher/plane/geometry/polygon.hpp"

namespace pcvt::plane {
namespace {

/// A triangle on the side from site i to site j of the polygon that remains.
struct DualTriangle {
    int apex = -1;
    DualMean vertex = {};
};

class DualPolygon {
   public:
    DualPolygon(std::span<const DualSite> sites, double rounding)
        : sites_(sites), rounding_(rounding) {}

    std::optional<DualMean> mean() const {
        DualMean sum{.point = Vec2::Zero()};
        std::vector<Vec2> vertices;
        // The chains i ... j of sites that are still to be divided.
        std::vector<std::pair<int, int>> chains{{0, static_cast<int>(sites_.size()) - 1}};
        while (!chains.empty()) {
            const auto [i, j] = chains.back();
            chains.pop_back();
            if (j - i < 2) continue;
            const DualTriangle triangle = triangle_on(i, j);
            if (triangle.apex < 0) return std::nullopt;
            sum.point += triangle.vertex.point;
            sum.error += triangle.vertex.error;
            vertices.push_back(triangle.vertex.point);
            chains.emplace_back(i, triangle.apex);
            chains.emplace_back(triangle.apex, j);
        }
        const double n = static_cast<double>(sites_.size()) - 2;
        DualMean mean{.point = sum.point / n, .error = sum.error / n};
        for (const Vec2& vertex : vertices) {
            mean.spread = std::max(mean.spread, (vertex - mean.point).norm());
        }
        return mean;
    }

   private:
    /// The triangle of sites i and j and the site of the chain between them whose circle contains
    /// no further site: its centre lies least far inside.
    DualTriangle triangle_on(int i, int j) const {
        DualTriangle best;
        const Vec2 side = sites_[j].point - sites_[i].point;
        const Vec2 inwards(side.y(), -side.x());
        double least = std::numeric_limits<double>::infinity();
        for (int m = i + 1; m < j; ++m) {
            if (!(inwards.dot(sites_[m].point - sites_[i].point) > 0)) continue;
            const DualMean vertex = vertex_of(i, m, j);
            const double depth = inwards.dot(vertex.point);
            if (!(depth < least)) continue;
            least = depth;
            best = {m, vertex};
        }
        return best;
    }

    /// The point of equal power distance from three sites.
    DualMean vertex_of(int i, int m, int j) const {
        const DualSite& origin = sites_[i];
        const Vec2 e = sites_[m].point - origin.point;
        const Vec2 f = sites_[j].point - origin.point;
        const double p = (e.squaredNorm() - sites_[m].weight + origin.weight) / 2;
        const double q = (f.squaredNorm() - sites_[j].weight + origin.weight) / 2;
        const double det = cross(e, f);
        const Vec2 way = Vec2(p * f.y() - q * e.y(), q * e.x() - p * f.x()) / det;
        // Cramer's rule with rows and right sides that are off by the rounding.
        const double size = e.norm() + f.norm();
        const double off = 2 * rounding_ * (size + way.norm());
        return {.point = origin.point + way, .error = off * size / std::abs(det)};
    }

    std::span<const DualSite> sites_;
    double rounding_;
};

}  // namespace

std::optional<DualMean> dual_mean(std::span<const DualSite> polygon, double rounding) {
    return DualPolygon(polygon, rounding).mean();
}

}  // namespace pcvt::plane
