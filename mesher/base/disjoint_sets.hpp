#pragma once

#include <numeric>
#include <utility>
#include <vector>

namespace pcvt {

/// A partition of 0 ... n - 1 that only gets coarser; each set is named by its smallest member.
class DisjointSets {
   public:
    explicit DisjointSets(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

    int find(int x) {
        while (parent_[x] != x) {
            parent_[x] = parent_[parent_[x]];
            x = parent_[x];
        }
        return x;
    }
    /// Returns false where x and y were in one set already.
    bool unite(int x, int y) {
        int low = find(x);
        int high = find(y);
        if (low == high) return false;
        if (high < low) std::swap(low, high);
        parent_[high] = low;
        return true;
    }

   private:
    std::vector<int> parent_;
};

}  // namespace pcvt
