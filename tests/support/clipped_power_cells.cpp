#include "tests/support/clipped_power_cells.hpp"

#include <cmath>

namespace pcvt::testing {
namespace {

constexpr int kFarthest = 3;

}  // namespace

std::vector<Polygon> clipped_power_cells(const Sites& sites, const Eigen::VectorXd& weights) {
    const Lattice& reduced = sites.reduction().reduced;
    const double far = 2 * (reduced.a().norm() + reduced.b().norm());
    std::vector<Polygon> cells;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        Polygon cell{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
        for (SiteId t = 0; t < sites.n_sites(); ++t) {
            for (int i = -kFarthest; i <= kFarthest; ++i) {
                for (int j = -kFarthest; j <= kFarthest; ++j) {
                    if (s == t && i == 0 && j == 0) continue;
                    const Vec2 u = sites.coordinates().col(t) - sites.coordinates().col(s);
                    const Vec2 d = reduced.to_plane(u + Vec2(i, j));
                    cell = clipped(cell, d, (d.squaredNorm() + weights[s] - weights[t]) / 2);
                }
            }
        }
        cells.push_back(cell);
    }
    return cells;
}

PolygonMoments polygon_moments(const Polygon& polygon) {
    PolygonMoments moments;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2& p = polygon[k];
        const Vec2& q = polygon[(k + 1) % polygon.size()];
        const double area = cross(p, q) / 2;
        moments.area += area;
        moments.first += area / 3 * (p + q);
        moments.second += area / 6 * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
    }
    return moments;
}

}  // namespace pcvt::testing
