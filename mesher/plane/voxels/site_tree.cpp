#include "mesher/plane/voxels/site_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::plane {
namespace {

constexpr int kSitesOfALeaf = 6;
/// In the domain of a reduced basis, the image of a point that is nearest to another point lies at
/// most this number of periods away along each period vector.
constexpr int kFarthestImage = 2;

}  // namespace

SiteTree::SiteTree(const Lattice& lattice, const Points& points, const Eigen::VectorXd& weights)
    : reduced_(reduce(lattice).reduced) {
    for (SiteId s = 0; s < points.cols(); ++s) {
        checkpoint_each(s);
        const Vec2 p = points.col(s);
        positions_.push_back(p + into_domain(p));
        weights_.push_back(weights.size() == 0 ? 0 : weights[s]);
        sites_.push_back(s);
    }
    for (int i = -kFarthestImage; i <= kFarthestImage; ++i) {
        for (int j = -kFarthestImage; j <= kFarthestImage; ++j) {
            translations_.push_back(reduced_.translation({i, j}));
        }
    }
    // Images that are near come first, so that they rule out the others.
    std::stable_sort(translations_.begin(), translations_.end(), [](const Vec2& s, const Vec2& t) {
        return s.squaredNorm() < t.squaredNorm();
    });
    build(0, n_sites());
}

int SiteTree::build(int begin, int end) {
    checkpoint();
    Node node{.least = positions_[sites_[begin]],
              .most = positions_[sites_[begin]],
              .largest_weight = -std::numeric_limits<double>::infinity(),
              .begin = begin,
              .end = end};
    for (int k = begin; k < end; ++k) {
        node.least = node.least.cwiseMin(positions_[sites_[k]]);
        node.most = node.most.cwiseMax(positions_[sites_[k]]);
        node.largest_weight = std::max(node.largest_weight, weights_[sites_[k]]);
    }
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
    if (end - begin <= kSitesOfALeaf) return index;
    // Split the longer side at its median.
    const Vec2 sides = node.most - node.least;
    const int axis = sides.x() >= sides.y() ? 0 : 1;
    const int middle = (begin + end) / 2;
    std::nth_element(sites_.begin() + begin, sites_.begin() + middle, sites_.begin() + end,
                     [&](SiteId s, SiteId t) { return positions_[s][axis] < positions_[t][axis]; });
    const int left = build(begin, middle);
    const int right = build(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
}

Vec2 SiteTree::into_domain(const Vec2& p) const {
    const Vec2 u = reduced_.to_lattice(p);
    return reduced_.translation(
        {-static_cast<int>(std::floor(u.x())), -static_cast<int>(std::floor(u.y()))});
}

double SiteTree::least_distance(const Node& node, const Vec2& p) const {
    const Vec2 outside = (node.least - p).cwiseMax(p - node.most).cwiseMax(0);
    return outside.squaredNorm() - node.largest_weight;
}

void SiteTree::look_at(SiteId site, const Vec2& p, const Vec2& translation,
                       NearestImage& best) const {
    const Vec2 from_point = positions_[site] + translation - p;
    const double distance = from_point.squaredNorm() - weights_[site];
    if (distance < best.power_distance) best = {site, from_point, distance};
}

void SiteTree::visit(int node, const Vec2& p, const Vec2& translation, NearestImage& best) const {
    const Node& at = nodes_[node];
    if (least_distance(at, p - translation) >= best.power_distance) return;
    if (at.left < 0) {
        for (int k = at.begin; k < at.end; ++k) look_at(sites_[k], p, translation, best);
        return;
    }
    // The child that may be nearer comes first.
    const Vec2 q = p - translation;
    const bool left_first =
        least_distance(nodes_[at.left], q) <= least_distance(nodes_[at.right], q);
    visit(left_first ? at.left : at.right, p, translation, best);
    visit(left_first ? at.right : at.left, p, translation, best);
}

NearestImage SiteTree::nearest(const Vec2& p) const {
    const Vec2 q = p + into_domain(p);
    NearestImage best{-1, Vec2::Zero(), std::numeric_limits<double>::infinity()};
    for (const Vec2& translation : translations_) visit(0, q, translation, best);
    return best;
}

NearestImage SiteTree::nearest_of(SiteId site, const Vec2& p) const {
    const Vec2 q = p + into_domain(p);
    NearestImage best{-1, Vec2::Zero(), std::numeric_limits<double>::infinity()};
    for (const Vec2& translation : translations_) look_at(site, q, translation, best);
    return best;
}

}  // namespace pcvt::plane
