#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/base/workers.hpp"
#include "mesher/delaunay/moving_delaunay.hpp"

namespace pcvt {

/// The neighbours round each site that moves, kept from one look to the next: to walk round a site
/// waits for the memory at each step, and few flips change few rings: an update looks at the
/// corners of their triangles only. Law, tested by number:
///   (1) After an update every ring is that of a fresh object, whatever happened in between.
class SiteRings {
   public:
    /// Both must outlive this object.
    SiteRings(const MovingDelaunay& delaunay, Workers& workers);

    /// Follows the triangulation.
    void update();

    static constexpr int kMost = 8;
    /// The neighbours round a site, counter-clockwise, from that of the least number on; of each
    /// the image without offset. `length` is 0 where that is not all: for more than kMost
    /// neighbours, or at the seam.
    struct Ring {
        std::array<SiteId, kMost> neighbours{};
        int length = 0;
    };
    const Ring& operator[](SiteId site) const { return rings_[site]; }
    /// Calls take(h) for the halfedges that lead from a site to its neighbours, in that order.
    template <class Take>
    void go_round(SiteId site, const Take& take) const {
        const int first = leaving_[site];
        int h = first;
        do {
            take(h);
            h = delaunay_.triangulation().next_round_site(h);
        } while (h != first);
    }

   private:
    void find_all();
    void find(SiteId site);

    const MovingDelaunay& delaunay_;
    Workers& workers_;
    /// For each site the halfedge that leads to the first neighbour.
    std::vector<int> leaving_;
    std::vector<Ring> rings_;
    /// How far the rings have followed.
    std::int64_t log_number_ = -1;
    std::size_t n_logged_ = 0;
};

}  // namespace pcvt
