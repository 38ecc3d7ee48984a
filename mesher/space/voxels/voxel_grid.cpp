#include "mesher/space/voxels/voxel_grid.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesher/base/error.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt::space {
namespace {

/// The largest part of a period across its axis.
constexpr double kRightAngle = 1e-9;
constexpr double kVoxelsAlongCell = 16;
/// The step by which the voxels along a cell become fewer until all voxels are not too many.
constexpr double kFewer = 0.98;

/// The lengths of the periods along x, y and z; nothing if they are not along different axes.
std::optional<Vec3> box_sides(const Lattice& lattice) {
    Vec3 sides = Vec3::Zero();
    for (const Vec3& period : lattice.periods()) {
        Eigen::Index axis = 0;
        Vec3 across = period.cwiseAbs();
        const double length = across.maxCoeff(&axis);
        across[axis] = 0;
        if (across.maxCoeff() > kRightAngle * length || sides[axis] != 0) return {};
        sides[axis] = length;
    }
    return sides;
}

Vec3 axis_periods(const Lattice& lattice) {
    if (const auto sides = box_sides(reduce(lattice).reduced)) return *sides;
    throw InvalidInput(
        "voxels need periods along x, y and z; use a lattice that is a box, such as the period "
        "1,1,1");
}

}  // namespace

VoxelCounts default_voxels(const Lattice& lattice, double n_cells) {
    const Vec3 periods = axis_periods(lattice);
    const double h = portable_cbrt(periods.prod() / n_cells);
    for (double along_cell = kVoxelsAlongCell;; along_cell *= kFewer) {
        const Vec3 wanted = periods * (along_cell / h);
        const VoxelCounts counts{even_voxel_count(wanted.x()), even_voxel_count(wanted.y()),
                                 even_voxel_count(wanted.z())};
        if (double(counts.x) * counts.y * counts.z <= kMostVoxels) return counts;
    }
}

VoxelGrid voxel_grid(const Lattice& lattice, const Vec3& origin, VoxelCounts counts) {
    const Vec3 periods = axis_periods(lattice);
    if (std::min({counts.x, counts.y, counts.z}) < kLeastVoxels) {
        throw InvalidInput(
            "voxels in space need three counts, NX,NY,NZ, each of them 2 or more; give them");
    }
    require_voxel_limits(counts);
    VoxelGrid grid{.corner = origin, .size = periods, .counts = counts};
    // A domain that is not a box is cut into one, with the same corner.
    if (box_sides(lattice)) {
        for (const Vec3& period : lattice.periods()) grid.corner += period.cwiseMin(0);
    }
    return grid;
}

}  // namespace pcvt::space
