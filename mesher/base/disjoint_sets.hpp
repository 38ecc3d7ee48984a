#pragma once

#include <numeric>
#include <utility>
#include <vector>

namespace pcvt {

/// A partition of 0 ... n - 1 that only becomes coarser (union-find); the smallest member of a set
/// represents it.
///
/// Example usage:
///
///     DisjointSets components(n_vertices);
///     for (const auto& [v, w] : edges) components.unite(v, w);
///     const bool connected = components.find(0) == components.find(1);
class DisjointSets {
   public:
    explicit DisjointSets(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

    /// Returns the representative of the set that contains x.
    int find(int x) {
        while (parent_[x] != x) {
            parent_[x] = parent_[parent_[x]];
            x = parent_[x];
        }
        return x;
    }
    /// Merges the sets of x and y; returns false if they were the same set already.
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
