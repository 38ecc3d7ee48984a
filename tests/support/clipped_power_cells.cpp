#include "tests/support/clipped_power_cells.hpp"

#include <cmath>

namespace pcvt::testing {
namespace {

constexpr int kFarthest = 3;

}  // namespace

std::vector<plane::Polygon> clipped_power_cells(const plane::Sites& sites,
                                                const Eigen::VectorXd& weights) {
    const plane::Lattice& reduced = sites.reduction().reduced;
    const double far = 2 * (reduced.a().norm() + reduced.b().norm());
    std::vector<plane::Polygon> cells;
    for (SiteId s = 0; s < sites.n_sites(); ++s) {
        plane::Polygon cell{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
        for (SiteId t = 0; t < sites.n_sites(); ++t) {
            for (int i = -kFarthest; i <= kFarthest; ++i) {
                for (int j = -kFarthest; j <= kFarthest; ++j) {
                    if (s == t && i == 0 && j == 0) continue;
                    const plane::Vec2 u = sites.coordinates().col(t) - sites.coordinates().col(s);
                    const plane::Vec2 d = reduced.to_position(u + plane::Vec2(i, j));
                    cell = plane::clipped(cell, d, (d.squaredNorm() + weights[s] - weights[t]) / 2);
                }
            }
        }
        cells.push_back(cell);
    }
    return cells;
}

PolygonMoments polygon_moments(const plane::Polygon& polygon) {
    PolygonMoments moments;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const plane::Vec2& p = polygon[k];
        const plane::Vec2& q = polygon[(k + 1) % polygon.size()];
        const double area = plane::cross(p, q) / 2;
        moments.area += area;
        moments.first += area / 3 * (p + q);
        moments.second += area / 6 * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
    }
    return moments;
}

}  // namespace pcvt::testing
