#pragma once

#include "mesher/optimize/fixed_pairs.hpp"
#include "mesher/plane/delaunay/moving_delaunay.hpp"

namespace pcvt::plane {

/// A condition that the positions of sites satisfy throughout a run: line searches shorten a step
/// that leads to others, as if the energy were infinite there.
class SiteGuard {
   public:
    /// Whether the coordinates are admitted; the triangulation need not be restored.
    virtual bool admits(const MovingDelaunay& delaunay) = 0;

   protected:
    ~SiteGuard() = default;
};

/// What a run may not change: sites, numbered as in the triangulation, and their guard's condition.
struct SiteConstraints {
    FixedPairs fixed;
    /// nullptr: none.
    SiteGuard* guard = nullptr;

    bool admit(const MovingDelaunay& delaunay) const {
        return guard == nullptr || guard->admits(delaunay);
    }
};

}  // namespace pcvt::plane
