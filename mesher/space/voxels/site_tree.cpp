#include "mesher/space/voxels/site_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {
namespace {

constexpr int kSitesOfALeaf = 6;
/// In the domain of a reduced basis, the image of a point that is nearest to a point less than half
/// a period outside of the domain lies at most this number of periods away along each period
/// vector.
constexpr int kFarthestImage = 3;
/// Images are kept that are not nearest by less than this part of the squared distance.
constexpr double kBoxRounding = 1e-12;

}  // namespace

SiteTree::SiteTree(const Lattice& lattice, const Points& points, const Eigen::VectorXd& weights)
    : reduced_(reduce(lattice).reduced) {
    for (SiteId s = 0; s < points.cols(); ++s) {
        checkpoint_each(s);
        positions_.push_back(into_domain(points.col(s)));
        weights_.push_back(weights.size() == 0 ? 0 : weights[s]);
        sites_.push_back(s);
    }
    for (int i = -kFarthestImage; i <= kFarthestImage; ++i) {
        for (int j = -kFarthestImage; j <= kFarthestImage; ++j) {
            for (int k = -kFarthestImage; k <= kFarthestImage; ++k) {
                translations_.push_back(reduced_.translation({i, j, k}));
            }
        }
    }
    // Images that are near come first, so that they rule out the others.
    std::stable_sort(translations_.begin(), translations_.end(), [](const Vec3& s, const Vec3& t) {
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
    // Split the longest side at its median.
    Eigen::Index axis = 0;
    (node.most - node.least).maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(sites_.begin() + begin, sites_.begin() + middle, sites_.begin() + end,
                     [&](SiteId s, SiteId t) { return positions_[s][axis] < positions_[t][axis]; });
    const int left = build(begin, middle);
    const int right = build(middle, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
}

Vec3 SiteTree::into_domain(const Vec3& p) const {
    const Vec3 whole = reduced_.to_lattice(p).array().floor();
    return p - reduced_.to_position(whole);
}

double SiteTree::least_distance(const Node& node, const Vec3& p, const Vec3& half) const {
    const Vec3 outside = (node.least - p - half).cwiseMax(p - half - node.most).cwiseMax(0);
    return outside.squaredNorm() - node.largest_weight;
}

NearestImage SiteTree::seen(SiteId site, const Vec3& p) const {
    return {site, positions_[site] - p, weights_[site]};
}

void SiteTree::visit(int node, const Vec3& p, NearestImage& best) const {
    const Node& at = nodes_[node];
    if (least_distance(at, p, Vec3::Zero()) >= best.power_distance()) return;
    if (at.left < 0) {
        for (int k = at.begin; k < at.end; ++k) {
            const NearestImage image = seen(sites_[k], p);
            if (image.power_distance() < best.power_distance()) best = image;
        }
        return;
    }
    // The child that may be nearer comes first.
    const bool left_first = least_distance(nodes_[at.left], p, Vec3::Zero()) <=
                            least_distance(nodes_[at.right], p, Vec3::Zero());
    visit(left_first ? at.left : at.right, p, best);
    visit(left_first ? at.right : at.left, p, best);
}

void SiteTree::collect(int node, const Vec3& p, const Vec3& half, double farthest,
                       std::vector<NearestImage>& found) const {
    const Node& at = nodes_[node];
    if (least_distance(at, p, half) > farthest) return;
    if (at.left < 0) {
        for (int k = at.begin; k < at.end; ++k) found.push_back(seen(sites_[k], p));
        return;
    }
    collect(at.left, p, half, farthest, found);
    collect(at.right, p, half, farthest, found);
}

NearestImage SiteTree::nearest(const Vec3& p) const {
    const Vec3 q = into_domain(p);
    NearestImage best{-1, Vec3::Zero(), -std::numeric_limits<double>::infinity()};
    for (const Vec3& translation : translations_) visit(0, q - translation, best);
    return best;
}

NearestImage SiteTree::nearest_of(SiteId site, const Vec3& p) const {
    const Vec3 q = into_domain(p);
    NearestImage best = seen(site, q);
    for (const Vec3& translation : translations_) {
        const NearestImage image = seen(site, q - translation);
        if (image.power_distance() < best.power_distance()) best = image;
    }
    return best;
}

std::vector<NearestImage> SiteTree::nearest_in_box(const Vec3& p, const Vec3& half) const {
    const Vec3 q = into_domain(p);
    const NearestImage first = nearest(p);
    // Its largest power distance to a point of the box; images that are farther from all points of
    // the box are not nearest anywhere in it.
    const double square = (first.from_point.cwiseAbs() + half).squaredNorm();
    const double slack = kBoxRounding * (square + std::abs(first.weight));
    std::vector<NearestImage> found;
    for (const Vec3& translation : translations_) {
        collect(0, q - translation, half, square - first.weight + slack, found);
    }
    // The difference of two power distances is linear in the point.
    std::erase_if(found, [&](const NearestImage& image) {
        const Vec3 apart = (image.from_point - first.from_point).cwiseAbs();
        return image.power_distance() - first.power_distance() - 2 * apart.dot(half) > slack;
    });
    return found;
}

}  // namespace pcvt::space
