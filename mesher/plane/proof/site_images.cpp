#include "mesher/plane/proof/site_images.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "mesher/base/law_violation.hpp"

namespace pcvt::plane {
namespace {

/// Offsets beyond this are refused, so that sums of offsets stay integers.
constexpr double kFarthest = 1 << 28;

}  // namespace

SiteImages::SiteImages(const Tile& tile, std::vector<Vec2> positions)
    : columns_(std::max(tile.columns, 1)),
      rows_(std::max(tile.rows, 1)),
      lattice_(tile.lattice.a() / columns_, tile.lattice.b() / rows_),
      reduction_(reduce(lattice_)),
      near_(reduction_.reduced.a().squaredNorm() / 4),
      positions_(std::move(positions)),
      lift_(tile.site_weights) {
    const double largest = lift_.empty() ? 0 : *std::max_element(lift_.begin(), lift_.end());
    for (double& w : lift_) w = largest - w;
}

Offset SiteImages::search(SiteId site, const Vec2& p) const {
    const Vec2 way = p - positions_[site];
    const Lattice& reduced = reduction_.reduced;
    const Vec2 u = reduced.to_lattice(way);
    if (!(u.cwiseAbs().maxCoeff() < kFarthest)) {
        throw_violation("of the sites",
                        "site " + std::to_string(site) + " lies too many periods away");
    }
    const Offset about{static_cast<int>(std::lround(u.x())), static_cast<int>(std::lround(u.y()))};
    Offset best;
    double least = std::numeric_limits<double>::infinity();
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
            const Offset offset = about + Offset{i, j};
            const double distance = (way - reduced.translation(offset)).squaredNorm();
            if (distance < least) {
                least = distance;
                best = offset;
            }
        }
    }
    return reduction_.to_original(best);
}

SiteImages::Side SiteImages::side_of(SiteId site, const Vec2& p) const {
    Side side{nearest(site, p), std::numeric_limits<double>::infinity()};
    const Vec2 way = p - position(site, side.offset);
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
            if (i == 0 && j == 0) continue;
            const Vec2 between = reduction_.reduced.translation({i, j});
            const double length = between.norm();
            side.depth = std::min(side.depth, length / 2 - way.dot(between) / length);
        }
    }
    return side;
}

}  // namespace pcvt::plane
