#pragma once

#include <numeric>
#include <vector>

#include "mesher/lattice/lattice.hpp"

namespace pcvt {

/// Orbits joined into larger ones: each knows its root and its offset to it.
class OffsetDisjointSets {
   public:
    explicit OffsetDisjointSets(int n) : parent_(n), offset_(n) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    struct Root {
        int orbit;
        Offset offset;
    };
    /// The point t stands where root.orbit + offset stands.
    Root root(int t) {
        Offset offset;
        while (parent_[t] != t) {
            // Each visit halves the path for the next one.
            const int parent = parent_[t];
            offset_[t] = offset_[t] + offset_[parent];
            parent_[t] = parent_[parent];
            offset = offset + offset_[t];
            t = parent_[t];
        }
        return {t, offset};
    }
    /// Says that t + offset stands where s stands. Returns false where they were joined before.
    bool join(int s, int t, Offset offset) {
        const Root rs = root(s);
        const Root rt = root(t);
        if (rs.orbit == rt.orbit) return false;
        // The smaller index becomes the root, so that the result does not depend on the order.
        const Offset t_to_s = rs.offset - (rt.offset + offset);
        if (rs.orbit < rt.orbit) {
            parent_[rt.orbit] = rs.orbit;
            offset_[rt.orbit] = t_to_s;
        } else {
            parent_[rs.orbit] = rt.orbit;
            offset_[rs.orbit] = -t_to_s;
        }
        return true;
    }

   private:
    std::vector<int> parent_;
    std::vector<Offset> offset_;
};

}  // namespace pcvt
