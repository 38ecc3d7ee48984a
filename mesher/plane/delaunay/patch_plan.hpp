#pragma once

#include <vector>

#include "mesher/plane/delaunay/torus_triangulation.hpp"

namespace pcvt::plane {

/// The sites and triangles of one patch (delaunay_patch.hpp), by their numbers in the whole
/// triangulation, ascending.
struct PatchPlan {
    /// The sites that move.
    std::vector<SiteId> moving;
    /// The other corners of the triangles.
    std::vector<SiteId> others;
    /// All triangles at sites that move and at their neighbours.
    std::vector<int> triangles;
};

/// Disjoint parts of a triangulation round some of its sites.
///
/// The sites that move are the given ones and `n_rings` rings of their neighbours, without fixed
/// ones. Parts whose rings meet are one patch; no two patches have a common triangle, and none has
/// a site that moves in another.
///
/// Example usage:
///
///     const PatchPlans plans(whole.triangulation(), {17, 4711}, is_fixed, 10);
///     for (int k = 0; k < plans.n_patches(); ++k) use(plans.patch(k));
class PatchPlans {
   public:
    /// @param first     sites in any order, each once.
    /// @param is_fixed  empty, or one entry for each site.
    /// Cost: two sweeps over all triangles, and time in proportion to the sites of the patches.
    PatchPlans(const TorusTriangulation& triangulation, const std::vector<SiteId>& first,
               const std::vector<bool>& is_fixed, int n_rings);

    int n_patches() const { return static_cast<int>(patches_.size()); }
    const PatchPlan& patch(int k) const { return patches_[k]; }
    /// The number of sites that move in all patches together.
    int n_moving() const { return n_moving_; }

    /// The place of a site of patch k in its lists, `moving` followed by `others`.
    int place_of_site(SiteId site) const { return site_places_[site]; }
    /// The place of a triangle in the list of patch k, or -1 if the patch does not have it.
    int place_of_triangle(int k, int triangle) const {
        const auto place = static_cast<std::size_t>(triangle_places_[triangle]);
        const std::vector<int>& own = patches_[k].triangles;
        return place < own.size() && own[place] == triangle ? static_cast<int>(place) : -1;
    }

   private:
    std::vector<PatchPlan> patches_;
    int n_moving_ = 0;
    /// Arbitrary for sites and triangles outside of all patches.
    std::vector<int> site_places_;
    std::vector<int> triangle_places_;
};

}  // namespace pcvt::plane
