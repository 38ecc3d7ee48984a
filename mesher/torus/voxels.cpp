#include "mesher/torus/voxels.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesher/base/error.hpp"

namespace pcvt {

int even_voxel_count(double wanted) {
    const double even = 2 * std::ceil(wanted / 2);
    return static_cast<int>(std::clamp<double>(even, kLeastVoxels, kMostVoxelsOfARow));
}

void require_voxel_limits(VoxelCounts counts) {
    const double n = double(counts.x) * counts.y * counts.z;
    if (n <= kMostVoxels && std::max({counts.x, counts.y, counts.z}) <= kMostVoxelsOfARow) return;
    throw LimitExceeded(std::to_string(counts.x) + " x " + std::to_string(counts.y) +
                        (counts.z > 1 ? " x " + std::to_string(counts.z) : "") +
                        " voxels are too many; take at most 2^28, and 2^20 along an axis");
}

std::vector<SiteId> unseen_cells(const std::vector<SiteId>& sites, int n_cells) {
    std::vector<bool> is_seen(static_cast<std::size_t>(n_cells));
    for (const SiteId s : sites) is_seen[s] = true;
    std::vector<SiteId> unseen;
    for (SiteId s = 0; s < n_cells; ++s) {
        if (!is_seen[s]) unseen.push_back(s);
    }
    return unseen;
}

}  // namespace pcvt
