#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mesher/base/site_id.hpp"
#include "mesher/space/energy/facet_heights.hpp"

namespace pcvt::space {

/// The tetrahedra of one task of a pass: whole blocks, except at the end.
struct SlabRange {
    int first = 0;
    int end = 0;
};

/// Divides tetrahedra into slabs, whose number does not depend on the number of threads.
inline std::vector<SlabRange> slabs_of(int n_tetrahedra) {
    // The least size of a slab, and the largest number of slabs.
    constexpr int kTetrahedraPerSlab = 50'000;
    constexpr int kMostSlabs = 32;
    const int n_slabs = std::clamp(n_tetrahedra / kTetrahedraPerSlab, 1, kMostSlabs);
    const int n_blocks = (n_tetrahedra + kTetrahedraPerBlock - 1) / kTetrahedraPerBlock;
    std::vector<SlabRange> slabs(static_cast<std::size_t>(n_slabs));
    for (int k = 0; k < n_slabs; ++k) {
        const auto limit = [&](int s) {
            return static_cast<int>(std::int64_t{n_blocks} * s / n_slabs) * kTetrahedraPerBlock;
        };
        slabs[k] = {limit(k), std::min(limit(k + 1), n_tetrahedra)};
    }
    return slabs;
}

/// Sums by site over the tetrahedra of a slab, in blocks of sites that are made where they are
/// needed: the tetrahedra have few of all sites as corners.
///
/// Example usage:
///
///     SlabSums<double> sums;
///     sums.clear(n_sites);
///     sums.data()[sums.place(site)] += volume;
///
/// @tparam Sum  zero where it is value-initialised.
template <class Sum>
class SlabSums {
   public:
    static constexpr int kBlock = 64;

    void clear(int n_sites) {
        place_.assign(n_blocks(n_sites), -1);
        sums_.clear();
    }
    static std::size_t n_blocks(int n_sites) {
        return static_cast<std::size_t>((n_sites + kBlock - 1) / kBlock);
    }
    /// The number in data() of a site's sums, which are made if there are none.
    int place(SiteId site) {
        int& place = place_[unsigned(site) / kBlock];
        if (place < 0) {
            place = static_cast<int>(sums_.size());
            sums_.resize(sums_.size() + kBlock);
        }
        return place + int(unsigned(site) % kBlock);
    }
    Sum* data() { return sums_.data(); }
    /// The sums of block b of the sites; null if there are none.
    const Sum* block(std::size_t b) const {
        return place_[b] >= 0 ? sums_.data() + place_[b] : nullptr;
    }

   private:
    /// Where the sums of each block begin, or -1.
    std::vector<int> place_;
    std::vector<Sum> sums_;
};

}  // namespace pcvt::space
