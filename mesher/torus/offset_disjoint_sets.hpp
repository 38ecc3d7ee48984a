#pragma once

#include <numeric>
#include <vector>

namespace pcvt {

/// A union-find structure over orbits that also tracks offsets: each orbit stores the root of its
/// set and its offset to it. `Offset` is the type of the offsets of a lattice of the plane or of
/// space.
///
/// Example usage:
///
///     OffsetDisjointSets<Offset> merged(n_vertices);
///     merged.join(0, 3, {1, 0});  // vertex 3 translated by (1, 0) coincides with vertex 0
///     const auto [orbit, offset] = merged.root(3);  // orbit 0, offset (-1, 0)
template <class Offset>
class OffsetDisjointSets {
   public:
    explicit OffsetDisjointSets(int n) : parent_(n), offset_(n) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    struct Root {
        int orbit;
        Offset offset;
    };
    /// Point t coincides with point root.orbit translated by root.offset.
    Root root(int t) {
        Offset offset{};
        while (parent_[t] != t) {
            // Each visit halves the path for the next visit.
            const int parent = parent_[t];
            offset_[t] = offset_[t] + offset_[parent];
            parent_[t] = parent_[parent];
            offset = offset + offset_[t];
            t = parent_[t];
        }
        return {t, offset};
    }
    /// Records that point t translated by `offset` coincides with point s. Returns false if the two
    /// were joined before.
    bool join(int s, int t, Offset offset) {
        const Root rs = root(s);
        const Root rt = root(t);
        if (rs.orbit == rt.orbit) return false;
        // The smaller index becomes the root, so that the result does not depend on the order of
        // joins.
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
