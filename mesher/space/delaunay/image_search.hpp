#pragma once

#include <functional>
#include <vector>

#include "mesher/space/delaunay/predicates.hpp"

namespace pcvt::space {

/// All images of the sites of a torus, for queries by distance. The sites are in a tree of balls;
/// each ball represents all of its images, so that a query takes time of order log n for sites that
/// are spread in any way, also where it reaches over thousands of periods.
///
/// Example usage:
///
///     const ImageSearch search(sites);
///     const Corner nearest = search.nearest(point, radius, [](const Corner&) { return true; });
class ImageSearch {
   public:
    using Admits = std::function<bool(const Corner&)>;

    /// The sites must outlive this object.
    explicit ImageSearch(const Sites& sites);

    const Gram& gram() const { return gram_; }
    /// By how much a ball of radius 1, in the unit of the Gram matrix, extends in each reduced
    /// coordinate.
    const Vec3& extent() const { return extent_; }
    /// The mean spacing h in the unit of the Gram matrix.
    double spacing() const { return spacing_; }

    /// The image nearest to a point among the admitted ones within `radius` of it (unit of the Gram
    /// matrix); of equally near ones always the same. Its site is -1 if there is none. The search
    /// considers the images of each site within two periods of its nearest one.
    /// @param point  coordinates of the reduced basis.
    Corner nearest(const Vec3& point, double radius, const Admits& admits) const;

   private:
    /// A range of sites, and a ball that contains them. The first child of a node follows it; the
    /// second one is node `second`, or -1.
    struct Node {
        int first;
        int last;
        int second;
        Vec3 centre;
        double radius;
    };
    struct Query;

    int add_node(int first, int last);
    Offset nearest_offset(const Vec3& displacement) const;
    double distance_to(const Node& node, const Vec3& point) const;
    void search(int n, Query& query) const;
    void visit(SiteId site, Query& query) const;
    double squared_length(const Vec3& d) const { return gram_.squared_length(d.x(), d.y(), d.z()); }

    const Sites& sites_;
    Gram gram_;
    Vec3 extent_;
    double spacing_;
    std::vector<SiteId> order_;
    std::vector<Node> nodes_;
};

}  // namespace pcvt::space
