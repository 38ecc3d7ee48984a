#include "mesher/space/delaunay/image_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {
namespace {

constexpr int kSitesPerLeaf = 4;
/// Distances of balls are rounded.
constexpr double kBallRounding = 1 + 1e-9;
/// The search covers the images of each site up to this many periods from the nearest one.
constexpr int kBeside = 2;

}  // namespace

struct ImageSearch::Query {
    const Vec3& point;
    const Admits& admits;
    /// The squared distance of the nearest image so far, or the square of the radius.
    double least;
    Corner found{-1, {}};
};

ImageSearch::ImageSearch(const Sites& sites)
    : sites_(sites),
      gram_(gram_of(sites.reduction().reduced)),
      order_(static_cast<std::size_t>(sites.n_sites())) {
    const Lattice& reduced = sites.reduction().reduced;
    const double unit = reduced.a().norm() / std::sqrt(gram_.aa);
    extent_ = unit * reduced.heights().cwiseInverse();
    spacing_ = sites.spacing() / unit;
    std::iota(order_.begin(), order_.end(), 0);
    add_node(0, sites.n_sites());
}

int ImageSearch::add_node(int first, int last) {
    checkpoint_each(last - first, 64);
    const Points& u = sites_.coordinates();
    Vec3 low = u.col(order_[first]);
    Vec3 high = low;
    for (int k = first; k < last; ++k) {
        low = low.cwiseMin(u.col(order_[k]));
        high = high.cwiseMax(u.col(order_[k]));
    }
    const auto n = static_cast<int>(nodes_.size());
    // Half of the sides of the box, and their lengths.
    const Vec3 half = (high - low) / 2;
    const Vec3 length =
        half.cwiseProduct(Vec3(std::sqrt(gram_.aa), std::sqrt(gram_.bb), std::sqrt(gram_.cc)));
    nodes_.push_back({first, last, -1, low + half, length.sum()});
    if (last - first <= kSitesPerLeaf) return n;
    Eigen::Index axis = 0;
    length.maxCoeff(&axis);
    const int middle = (first + last) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](SiteId s, SiteId t) {
                         return u(axis, s) != u(axis, t) ? u(axis, s) < u(axis, t) : s < t;
                     });
    add_node(first, middle);
    const int second = add_node(middle, last);
    nodes_[n].second = second;
    return n;
}

/// The offset nearest to a displacement. In a Minkowski-reduced basis, an offset is the nearest one
/// if none of its 26 neighbours is nearer (P. Nguyen, D. Stehle 2009).
Offset ImageSearch::nearest_offset(const Vec3& displacement) const {
    const Vec3 whole = displacement.array().round();
    Offset nearest{int(whole.x()), int(whole.y()), int(whole.z())};
    double least = squared_length(displacement - whole);
    // Within half of the shortest period there is only one.
    for (bool nearer = true; nearer && least > gram_.aa / 4;) {
        nearer = false;
        const Offset middle = nearest;
        for (int o = 0; o < 27; ++o) {
            const Offset other = middle + Offset{o / 9 - 1, o / 3 % 3 - 1, o % 3 - 1};
            const double length = squared_length(displacement - other.vector());
            if (!(length < least)) continue;
            least = length;
            nearest = other;
            nearer = true;
        }
    }
    return nearest;
}

double ImageSearch::distance_to(const Node& node, const Vec3& point) const {
    const Vec3 d = point - node.centre;
    return std::sqrt(squared_length(d - nearest_offset(d).vector())) - node.radius;
}

void ImageSearch::visit(SiteId site, Query& query) const {
    const Vec3 from = query.point - sites_.coordinates().col(site);
    const Offset nearest = nearest_offset(from);
    if (squared_length(from - nearest.vector()) > kBallRounding * query.least) return;
    constexpr int kSide = 2 * kBeside + 1;
    for (int o = 0; o < kSide * kSide * kSide; ++o) {
        const Offset beside{o / (kSide * kSide) - kBeside, o / kSide % kSide - kBeside,
                            o % kSide - kBeside};
        const Corner corner{site, nearest + beside};
        const double distance =
            squared_length(image(sites_.coordinates(), corner).at - query.point);
        if (distance > query.least || !query.admits(corner)) continue;
        if (distance == query.least && query.found.site >= 0 && !(corner < query.found)) continue;
        query.least = distance;
        query.found = corner;
    }
}

void ImageSearch::search(int n, Query& query) const {
    const Node& node = nodes_[n];
    if (node.second < 0) {
        for (int k = node.first; k < node.last; ++k) visit(order_[k], query);
        return;
    }
    std::array<std::pair<double, int>, 2> children{
        {{distance_to(nodes_[n + 1], query.point), n + 1},
         {distance_to(nodes_[node.second], query.point), node.second}}};
    if (children[1].first < children[0].first) std::swap(children[0], children[1]);
    for (const auto& [distance, child] : children) {
        if (distance <= kBallRounding * std::sqrt(query.least)) search(child, query);
    }
}

Corner ImageSearch::nearest(const Vec3& point, double radius, const Admits& admits) const {
    checkpoint();
    Query query{point, admits, radius * radius};
    search(0, query);
    return query.found;
}

}  // namespace pcvt::space
