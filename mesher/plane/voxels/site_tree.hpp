#pragma once

#include <vector>

#include "mesher/plane/geometry/sites.hpp"

namespace pcvt::plane {

/// The image of a site, length units.
struct NearestImage {
    SiteId site;
    /// The vector from the point to the site, length units. It keeps the digits that a position
    /// far from the origin loses.
    Vec2 from_point;
    /// |from_point|^2 - w
    double power_distance;
};

/// Finds the nearest image of any site in the power distance, in doubles and without a
/// triangulation: a tree of boxes of sites, each with its largest weight. The tree tests
/// voxel_image() and files.
///
/// Example usage:
///
///     const SiteTree tree(lattice, points, weights);
///     const NearestImage image = tree.nearest({0.3, 0.4});
///
/// Law, tested by number:
///   (1) No image is nearer than the one found by more than rounding.
class SiteTree {
   public:
    /// @param lattice  any basis.
    /// @param points   2 x n, length units; need not be wrapped.
    /// @param weights  length^2, one a site, or empty.
    SiteTree(const Lattice& lattice, const Points& points, const Eigen::VectorXd& weights);

    int n_sites() const { return static_cast<int>(sites_.size()); }
    /// Cost: of order log n.
    NearestImage nearest(const Vec2& p) const;
    /// The nearest image of one site.
    NearestImage nearest_of(SiteId site, const Vec2& p) const;

   private:
    /// The sites of [begin, end) in `sites_`; leaves have no children.
    struct Node {
        Vec2 least;
        Vec2 most;
        double largest_weight;
        int begin;
        int end;
        int left = -1;
        int right = -1;
    };

    int build(int begin, int end);
    double least_distance(const Node& node, const Vec2& p) const;
    void visit(int node, const Vec2& p, const Vec2& translation, NearestImage& best) const;
    void look_at(SiteId site, const Vec2& p, const Vec2& translation, NearestImage& best) const;
    /// The translation that brings p into the domain of the reduced basis.
    Vec2 into_domain(const Vec2& p) const;

    Lattice reduced_;
    /// In the domain of the reduced basis.
    std::vector<Vec2> positions_;
    std::vector<double> weights_;
    std::vector<SiteId> sites_;
    std::vector<Node> nodes_;
    /// Those that can bring an image of a point of the domain next to another point of it.
    std::vector<Vec2> translations_;
};

}  // namespace pcvt::plane
