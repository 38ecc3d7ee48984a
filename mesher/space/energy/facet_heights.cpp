#include "mesher/space/energy/facet_heights.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/base/prefetch.hpp"

namespace pcvt::space {
namespace {

/// The rounding of two heights and of their sum to single precision, relative to both; rounded up.
constexpr float kSumError = 0x1p-22F;
/// The number of suspects by which the prefetch of their heights is ahead.
constexpr std::size_t kSuspectsFetched = 8;

}  // namespace

void FacetHeights::keep(int first, const std::array<BlockRow, 4>& height) {
    float* to = heights_.data() + 4 * std::size_t(first);
    for (const BlockRow& row : height) {
        for (const double h : row) *to++ = static_cast<float>(h);
    }
}

void FacetHeights::remove_certain(const TorusTetrahedra& tetrahedra,
                                  std::vector<int>& facets) const {
    const auto later = [&](std::size_t k) { return facets[std::min(k, facets.size() - 1)]; };
    std::size_t n_kept = 0;
    for (std::size_t k = 0; k < facets.size(); ++k) {
        const int f = facets[k];
        tetrahedra.fetch_opposite(later(k + 2 * kSuspectsFetched));
        const int next = later(k + kSuspectsFetched);
        for (const int g : {next, tetrahedra.opposite(next)}) prefetch(&heights_[place(g)]);
        const float here = heights_[place(f)];
        const float there = heights_[place(tetrahedra.opposite(f))];
        const bool certain = here + there > kSumError * (std::abs(here) + std::abs(there));
        if (!certain) facets[n_kept++] = f;
    }
    facets.resize(n_kept);
}

}  // namespace pcvt::space
