#pragma once

#include <vector>

#include "mesher/space/geometry/sites.hpp"

namespace pcvt::space {

/// The image of a site, length units.
struct NearestImage {
    SiteId site;
    /// The vector from the point to the site, length units. It keeps the digits that a position
    /// far from the origin loses.
    Vec3 from_point;
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
class SiteTree {
   public:
    /// @param lattice  any basis.
    /// @param points   3 x n, length units; need not be wrapped.
    /// @param weights  length^2, one a site, or empty.
    SiteTree(const Lattice& lattice, const Points& points, const Eigen::VectorXd& weights);

    int n_sites() const { return static_cast<int>(sites_.size()); }
    /// Cost: of order log n.
    NearestImage nearest(const Vec3& p) const;
    /// The nearest image of one site.
    NearestImage nearest_of(SiteId site, const Vec3& p) const;
    /// The images that may be nearest to a point of a box.
    /// @param half  half of the sides of the box round p, each at most that of a period.
    std::vector<NearestImage> nearest_in_box(const Vec3& p, const Vec3& half) const;

   private:
    /// The sites of [begin, end) in `sites_`; leaves have no children.
    struct Node {
        Vec3 least;
        Vec3 most;
        double largest_weight;
        int begin;
        int end;
        int left = -1;
        int right = -1;
    };

    int build(int begin, int end);
    /// The least power distance of the sites of a node to the points of a box.
    double least_distance(const Node& node, const Vec3& p, const Vec3& half) const;
    NearestImage seen(SiteId site, const Vec3& p) const;
    void visit(int node, const Vec3& p, NearestImage& best) const;
    void collect(int node, const Vec3& p, const Vec3& half, double farthest,
                 std::vector<NearestImage>& found) const;
    /// The image of p in the domain of the reduced basis.
    Vec3 into_domain(const Vec3& p) const;

    Lattice reduced_;
    /// In the domain of the reduced basis.
    std::vector<Vec3> positions_;
    std::vector<double> weights_;
    std::vector<SiteId> sites_;
    std::vector<Node> nodes_;
    /// Those that can bring an image of a point of the domain next to another point of it.
    std::vector<Vec3> translations_;
};

}  // namespace pcvt::space
