#include "mesher/plane/delaunay/patch_plan.hpp"

#include <utility>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/disjoint_sets.hpp"

namespace pcvt::plane {
namespace {

/// A breadth-first search from several sites at once.
class RingSearch {
   public:
    RingSearch(const TorusTriangulation& triangulation, const std::vector<SiteId>& first);

    /// A site that was reached.
    struct Reached {
        SiteId site;
        /// A halfedge that leaves it.
        int halfedge;
        /// The place in `first` of the site from which it was reached, and the number of its ring.
        int origin;
        int ring;
    };

    /// Reaches the sites of all rings up to `last` + 1, and the triangles at those up to `last`.
    void run(int last);

    const std::vector<Reached>& reached() const { return reached_; }
    /// For each site its place in reached(), or -1.
    std::vector<int>& place_of_site() { return place_; }
    /// For each triangle the origin of the site from which it was reached, or -1.
    std::vector<int>& origin_of_triangle() { return triangle_origin_; }
    /// The least origin of the sites in the same part.
    int part(int origin) { return parts_.find(origin); }

   private:
    void find_halfedges();
    void look_round(int k);

    const TorusTriangulation& triangulation_;
    std::vector<Reached> reached_;
    std::vector<int> place_;
    std::vector<int> triangle_origin_;
    DisjointSets parts_;
};

RingSearch::RingSearch(const TorusTriangulation& triangulation, const std::vector<SiteId>& first)
    : triangulation_(triangulation),
      place_(static_cast<std::size_t>(triangulation.n_sites()), -1),
      triangle_origin_(static_cast<std::size_t>(triangulation.n_triangles()), -1),
      parts_(static_cast<int>(first.size())) {
    for (const SiteId site : first) {
        const auto k = static_cast<int>(reached_.size());
        place_[site] = k;
        reached_.push_back({.site = site, .halfedge = -1, .origin = k, .ring = 0});
    }
    find_halfedges();
}

void RingSearch::find_halfedges() {
    const std::span<const SiteId> sites = triangulation_.corner_sites();
    for (int h = 0; h < triangulation_.n_halfedges(); ++h) {
        checkpoint_each(h);
        const int k = place_[sites[h]];
        if (k >= 0) reached_[k].halfedge = h;
    }
}

void RingSearch::look_round(int k) {
    const Reached here = reached_[k];
    const std::span<const SiteId> sites = triangulation_.corner_sites();
    int h = here.halfedge;
    do {
        triangle_origin_[h / 3] = here.origin;
        const int next = TorusTriangulation::next(h);
        int& place = place_[sites[next]];
        if (place < 0) {
            place = static_cast<int>(reached_.size());
            reached_.push_back({.site = sites[next],
                                .halfedge = next,
                                .origin = here.origin,
                                .ring = here.ring + 1});
        } else if (reached_[place].origin != here.origin) {
            parts_.unite(here.origin, reached_[place].origin);
        }
        h = triangulation_.next_round_site(h);
    } while (h != here.halfedge);
}

void RingSearch::run(int last) {
    for (int k = 0; k < static_cast<int>(reached_.size()) && reached_[k].ring <= last; ++k) {
        checkpoint_each(k);
        look_round(k);
    }
}

}  // namespace

PatchPlans::PatchPlans(const TorusTriangulation& triangulation, const std::vector<SiteId>& first,
                       const std::vector<bool>& is_fixed, int n_rings) {
    RingSearch search(triangulation, first);
    search.run(n_rings + 1);
    // Number the parts.
    std::vector<int> number(first.size());
    for (int origin = 0; origin < static_cast<int>(first.size()); ++origin) {
        const int part = search.part(origin);
        if (part == origin) patches_.emplace_back();
        number[origin] = part == origin ? n_patches() - 1 : number[part];
    }
    // Distribute the sites and triangles in their own order.
    site_places_ = std::move(search.place_of_site());
    for (SiteId site = 0; site < triangulation.n_sites(); ++site) {
        if (site_places_[site] < 0) continue;
        const RingSearch::Reached& reached = search.reached()[site_places_[site]];
        PatchPlan& patch = patches_[number[reached.origin]];
        const bool moves = reached.ring <= n_rings && (is_fixed.empty() || !is_fixed[site]);
        (moves ? patch.moving : patch.others).push_back(site);
    }
    triangle_places_ = std::move(search.origin_of_triangle());
    for (int t = 0; t < triangulation.n_triangles(); ++t) {
        if (triangle_places_[t] < 0) continue;
        std::vector<int>& triangles = patches_[number[triangle_places_[t]]].triangles;
        triangle_places_[t] = static_cast<int>(triangles.size());
        triangles.push_back(t);
    }
    // Number the sites of each patch, those that move first.
    for (const PatchPlan& patch : patches_) {
        int next = 0;
        for (const SiteId site : patch.moving) site_places_[site] = next++;
        for (const SiteId site : patch.others) site_places_[site] = next++;
        n_moving_ += static_cast<int>(patch.moving.size());
    }
}

}  // namespace pcvt::plane
