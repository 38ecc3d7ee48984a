#include "mesher/space/site_grid.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// More boxes than this in one direction do not make queries faster, even of the thinnest lattice.
constexpr double kMostBoxes = 1 << 10;

int floor_divided(int x, int y) { return x >= 0 ? x / y : -((-x + y - 1) / y); }

}  // namespace

SiteGrid::SiteGrid(const SpaceSites& sites)
    : sites_(sites), gram_(gram_of(sites.reduction().reduced)) {
    const SpaceLattice& reduced = sites.reduction().reduced;
    const double unit = reduced.a().norm() / std::sqrt(gram_.aa);
    extent_ = unit * reduced.heights().cwiseInverse();
    spacing_ = sites.spacing() / unit;
    for (int k = 0; k < 3; ++k) {
        n_boxes_[k] = int(std::clamp(1 / (extent_[k] * spacing_), 1.0, kMostBoxes));
    }
    // Count the members of each box, then place them.
    const auto box = [this](SiteId s) {
        int number = 0;
        for (int k = 0; k < 3; ++k) {
            const auto at = int(sites_.coordinates()(k, s) * n_boxes_[k]);
            number = number * n_boxes_[k] + std::min(at, n_boxes_[k] - 1);
        }
        return number;
    };
    const int n_all = n_boxes_[0] * n_boxes_[1] * n_boxes_[2];
    begin_.assign(static_cast<std::size_t>(n_all) + 2, 0);
    for (SiteId s = 0; s < sites.n_sites(); ++s) ++begin_[box(s) + 2];
    for (int b = 0; b < n_all; ++b) begin_[b + 2] += begin_[b + 1];
    members_.resize(static_cast<std::size_t>(sites.n_sites()));
    for (SiteId s = 0; s < sites.n_sites(); ++s) members_[begin_[box(s) + 1]++] = s;
}

Corner3 SiteGrid::nearest(const Vec3& point, double radius, const Admits& admits) const {
    // Balls of growing radii, so that a large radius costs nothing where an image is near.
    for (double r = spacing_; r < radius; r *= 2) {
        const Corner3 found = nearest_in_boxes(point, r, admits);
        if (found.site >= 0) return found;
    }
    return nearest_in_boxes(point, radius, admits);
}

Corner3 SiteGrid::nearest_in_boxes(const Vec3& point, double radius, const Admits& admits) const {
    Corner3 found{-1, {}};
    double least = radius * radius;
    const Vec3 reach = radius * extent_;
    std::array<int, 3> low;
    std::array<int, 3> high;
    for (int k = 0; k < 3; ++k) {
        low[k] = int(std::floor((point[k] - reach[k]) * n_boxes_[k]));
        high[k] = int(std::floor((point[k] + reach[k]) * n_boxes_[k]));
    }
    const auto visit_box = [&](int x, int y, int z) {
        const Offset3 offset{floor_divided(x, n_boxes_[0]), floor_divided(y, n_boxes_[1]),
                             floor_divided(z, n_boxes_[2])};
        const int box =
            ((x - offset.i * n_boxes_[0]) * n_boxes_[1] + (y - offset.j * n_boxes_[1])) *
                n_boxes_[2] +
            (z - offset.k * n_boxes_[2]);
        for (int m = begin_[box]; m < begin_[box + 1]; ++m) {
            const Corner3 corner{members_[m], offset};
            const Vec3 d = image(sites_.coordinates(), corner).at - point;
            const double distance = gram_.squared_length(d.x(), d.y(), d.z());
            if (distance > least || !admits(corner)) continue;
            if (distance == least && found.site >= 0 && !(corner < found)) continue;
            least = distance;
            found = corner;
        }
    };
    for (int x = low[0]; x <= high[0]; ++x) {
        checkpoint();
        for (int y = low[1]; y <= high[1]; ++y) {
            for (int z = low[2]; z <= high[2]; ++z) visit_box(x, y, z);
        }
    }
    return found;
}

}  // namespace pcvt
