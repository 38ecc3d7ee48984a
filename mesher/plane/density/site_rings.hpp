#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesher/base/workers.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"

namespace pcvt::plane {

/// The neighbours round each moving site, cached between evaluations. A walk round a site waits for
/// memory at each step, but few flips change few rings, so that an update examines only the corners
/// of flipped triangles.
///
/// Law, tested by number:
///   (1) After an update every ring equals that of a new object, after any sequence of moves.
class SiteRings {
   public:
    /// Both must outlive this object.
    SiteRings(const MovingDelaunay& delaunay, Workers& workers);

    /// Updates the rings to the triangulation.
    void update();

    static constexpr int kMost = 8;
    /// The neighbours round a site, counter-clockwise, from the smallest id on; each neighbour is
    /// the image without offset. `length` is 0 if this does not describe the ring: for more than
    /// kMost neighbours, or at the seam.
    struct Ring {
        std::array<SiteId, kMost> neighbours{};
        int length = 0;
    };
    const Ring& operator[](SiteId site) const { return rings_[site]; }
    /// Calls take(h) for the halfedges from a site to its neighbours, in the same order.
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
    /// For each site the halfedge to its first neighbour.
    std::vector<int> leaving_;
    std::vector<Ring> rings_;
    /// The log, and its entries that the rings include.
    std::int64_t log_number_ = -1;
    std::size_t n_logged_ = 0;
};

}  // namespace pcvt::plane
