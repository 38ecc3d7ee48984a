#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/site_id.hpp"

namespace pcvt {

/// The image of a site in D dimensions, length units.
template <int D>
struct NearestImage {
    SiteId site;
    /// The vector from the point to the site, length units. It keeps the digits that a position
    /// far from the origin loses.
    Eigen::Matrix<double, D, 1> from_point;
    double weight;

    /// |from_point|^2 - w
    double power_distance() const { return from_point.squaredNorm() - weight; }
};

/// Finds the nearest images of sites in the power distance, in doubles and without a triangulation:
/// a tree of boxes of sites, each with its largest weight. The tree tests voxel_image() and files.
///
/// Example usage:
///
///     const SiteTree tree(lattice, points, weights);
///     const NearestImage image = tree.nearest({0.3, 0.4, 0.5});
///
/// Laws, tested by number:
///   (1) No image is nearer than the one found by more than rounding.
///   (2) For each point of a box, one of the images that may be nearest is the nearest, up to
///       rounding.
template <class Lattice>
class SiteTree {
   public:
    static constexpr int kDimension = Lattice::kDimension;
    using Point = typename Lattice::Point;
    using Points = typename Lattice::Points;
    using Image = NearestImage<kDimension>;

    /// @param lattice  any basis.
    /// @param points   D x n, length units; need not be wrapped.
    /// @param weights  length^2, one a site, or empty.
    SiteTree(const Lattice& lattice, const Points& points, const Eigen::VectorXd& weights);

    int n_sites() const { return static_cast<int>(sites_.size()); }
    /// Cost: of order log n.
    Image nearest(const Point& p) const;
    /// The nearest image of one site.
    Image nearest_of(SiteId site, const Point& p) const;
    /// The images that may be nearest to a point of a box.
    /// @param half  half of the sides of the box round p, each at most that of a period.
    std::vector<Image> nearest_in_box(const Point& p, const Point& half) const;

   private:
    static constexpr int kSitesOfALeaf = 6;
    /// In the domain of a reduced basis, the image of a point that is nearest to a point less than
    /// half a period outside of the domain lies at most this number of periods away along each
    /// period vector.
    static constexpr int kFarthestImage = 3;
    /// Images are kept that are not nearest by less than this part of the squared distance.
    static constexpr double kBoxRounding = 1e-12;
    /// Wrapped points lie in the domain up to rounding.
    static constexpr double kRounding = 1 + 1e-9;

    /// The sites of [begin, end) in `sites_`; leaves have no children.
    struct Node {
        Point least;
        Point most;
        double largest_weight;
        int begin;
        int end;
        int left = -1;
        int right = -1;
    };

    int build(int begin, int end);
    /// The least power distance of the sites of a node to the points of a box.
    double least_distance(const Node& node, const Point& p, const Point& half) const;
    Image seen(SiteId site, const Point& p) const;
    void visit(int node, const Point& p, Image& best) const;
    void collect(int node, const Point& p, const Point& half, double farthest,
                 std::vector<Image>& found) const;
    /// The image of p in the domain of the reduced basis.
    Point into_domain(const Point& p) const;

    Lattice reduced_;
    /// In the domain of the reduced basis.
    std::vector<Point> positions_;
    std::vector<double> weights_;
    std::vector<SiteId> sites_;
    std::vector<Node> nodes_;
    /// Those that can bring an image of a point of the domain next to another point of it, short
    /// ones first.
    std::vector<Point> translations_;
    std::vector<double> lengths_;
    /// An upper bound of the distance of two points of the domain.
    double diameter_ = 0;
};

template <class Lattice>
SiteTree<Lattice>::SiteTree(const Lattice& lattice, const Points& points,
                            const Eigen::VectorXd& weights)
    : reduced_(reduce(lattice).reduced) {
    for (SiteId s = 0; s < points.cols(); ++s) {
        checkpoint_each(s);
        positions_.push_back(into_domain(points.col(s)));
        weights_.push_back(weights.size() == 0 ? 0 : weights[s]);
        sites_.push_back(s);
    }
    constexpr int kSide = 2 * kFarthestImage + 1;
    const int n = kDimension == 2 ? kSide * kSide : kSide * kSide * kSide;
    for (int image = 0; image < n; ++image) {
        Point periods;
        for (int axis = kDimension - 1, rest = image; axis >= 0; --axis, rest /= kSide) {
            periods[axis] = rest % kSide - kFarthestImage;
        }
        translations_.push_back(reduced_.to_position(periods));
    }
    // Images that are near come first, so that they rule out the others.
    std::stable_sort(
        translations_.begin(), translations_.end(),
        [](const Point& s, const Point& t) { return s.squaredNorm() < t.squaredNorm(); });
    for (const Point& translation : translations_) lengths_.push_back(translation.norm());
    for (int signs = 0; signs < 1 << kDimension; ++signs) {
        Point diagonal;
        for (int axis = 0; axis < kDimension; ++axis) diagonal[axis] = signs >> axis & 1 ? 1 : -1;
        diameter_ = std::max(diameter_, kRounding * reduced_.to_position(diagonal).norm());
    }
    build(0, n_sites());
}

template <class Lattice>
int SiteTree<Lattice>::build(int begin, int end) {
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

template <class Lattice>
typename SiteTree<Lattice>::Point SiteTree<Lattice>::into_domain(const Point& p) const {
    const Point whole = reduced_.to_lattice(p).array().floor();
    return p - reduced_.to_position(whole);
}

template <class Lattice>
double SiteTree<Lattice>::least_distance(const Node& node, const Point& p,
                                         const Point& half) const {
    const Point outside = (node.least - p - half).cwiseMax(p - half - node.most).cwiseMax(0);
    return outside.squaredNorm() - node.largest_weight;
}

template <class Lattice>
typename SiteTree<Lattice>::Image SiteTree<Lattice>::seen(SiteId site, const Point& p) const {
    return {site, positions_[site] - p, weights_[site]};
}

template <class Lattice>
void SiteTree<Lattice>::visit(int node, const Point& p, Image& best) const {
    const Node& at = nodes_[node];
    if (least_distance(at, p, Point::Zero()) >= best.power_distance()) return;
    if (at.left < 0) {
        for (int k = at.begin; k < at.end; ++k) {
            const Image image = seen(sites_[k], p);
            if (image.power_distance() < best.power_distance()) best = image;
        }
        return;
    }
    // The child that may be nearer comes first.
    const bool left_first = least_distance(nodes_[at.left], p, Point::Zero()) <=
                            least_distance(nodes_[at.right], p, Point::Zero());
    visit(left_first ? at.left : at.right, p, best);
    visit(left_first ? at.right : at.left, p, best);
}

template <class Lattice>
void SiteTree<Lattice>::collect(int node, const Point& p, const Point& half, double farthest,
                                std::vector<Image>& found) const {
    const Node& at = nodes_[node];
    if (least_distance(at, p, half) > farthest) return;
    if (at.left < 0) {
        for (int k = at.begin; k < at.end; ++k) found.push_back(seen(sites_[k], p));
        return;
    }
    collect(at.left, p, half, farthest, found);
    collect(at.right, p, half, farthest, found);
}

template <class Lattice>
typename SiteTree<Lattice>::Image SiteTree<Lattice>::nearest(const Point& p) const {
    const Point q = into_domain(p);
    Image best{-1, Point::Zero(), -std::numeric_limits<double>::infinity()};
    for (std::size_t k = 0; k < translations_.size(); ++k) {
        // Images by this translation, and by longer ones, are at least so far from q.
        const double gap = lengths_[k] - diameter_;
        if (gap > 0 && gap * gap - nodes_.front().largest_weight >= best.power_distance()) break;
        visit(0, q - translations_[k], best);
    }
    return best;
}

template <class Lattice>
typename SiteTree<Lattice>::Image SiteTree<Lattice>::nearest_of(SiteId site, const Point& p) const {
    const Point q = into_domain(p);
    Image best = seen(site, q);
    for (const Point& translation : translations_) {
        const Image image = seen(site, q - translation);
        if (image.power_distance() < best.power_distance()) best = image;
    }
    return best;
}

template <class Lattice>
std::vector<typename SiteTree<Lattice>::Image> SiteTree<Lattice>::nearest_in_box(
    const Point& p, const Point& half) const {
    const Point q = into_domain(p);
    const Image first = nearest(p);
    // Its largest power distance to a point of the box; images that are farther from all points of
    // the box are not nearest anywhere in it.
    const double square = (first.from_point.cwiseAbs() + half).squaredNorm();
    const double slack = kBoxRounding * (square + std::abs(first.weight));
    std::vector<Image> found;
    for (const Point& translation : translations_) {
        collect(0, q - translation, half, square - first.weight + slack, found);
    }
    // The difference of two power distances is linear in the point.
    std::erase_if(found, [&](const Image& image) {
        const Point apart = (image.from_point - first.from_point).cwiseAbs();
        return image.power_distance() - first.power_distance() - 2 * apart.dot(half) > slack;
    });
    return found;
}

}  // namespace pcvt
