#pragma once

#include "mesher/optimize/fixed_blocks.hpp"

namespace pcvt {

/// A condition that the positions of sites satisfy throughout a run: line searches shorten a step
/// that leads to others, as if the energy were infinite there.
template <class Moving>
class SiteGuard {
   public:
    /// Whether the coordinates are admitted; the triangulation need not be restored.
    virtual bool admits(const Moving& moving) = 0;

   protected:
    ~SiteGuard() = default;
};

/// The constraints of a run: fixed sites, numbered as in the moving triangulation, and a guard of
/// positions.
template <class Moving>
struct SiteConstraints {
    FixedBlocks fixed;
    /// nullptr: none.
    SiteGuard<Moving>* guard = nullptr;

    bool admit(const Moving& moving) const { return guard == nullptr || guard->admits(moving); }
};

}  // namespace pcvt
