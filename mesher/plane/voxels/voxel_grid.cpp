#include "mesher/plane/voxels/voxel_grid.hpp"

#include <cmath>

#include "mesher/base/error.hpp"
#include "mesher/plane/geometry/domain.hpp"

namespace pcvt::plane {
namespace {

/// The largest deviation of a period from its axis, over its length.
constexpr double kRightAngle = 1e-9;
constexpr double kVoxelsAlongCell = 16;

bool is_along_axes(const Vec2& a, const Vec2& b) {
    return a.y() <= kRightAngle * a.x() && b.x() <= kRightAngle * b.y();
}

/// The periods of a lattice along x and y.
Vec2 axis_periods(const Lattice& lattice) {
    const Lattice reduced = reduce(lattice).reduced;
    const Vec2 a = reduced.a().cwiseAbs();
    const Vec2 b = reduced.b().cwiseAbs();
    if (is_along_axes(a, b)) return {a.x(), b.y()};
    if (is_along_axes(b, a)) return {b.x(), a.y()};
    throw InvalidInput(
        "voxels need periods along x and y; use a rectangular lattice, or a repetition that is "
        "rectangular");
}

void require_counts(VoxelCounts counts) {
    if (counts.x < kLeastVoxels || counts.y < kLeastVoxels) {
        throw InvalidInput("there are fewer than 2 voxels along an axis; take at least 2");
    }
    if (counts.z < 1) throw InvalidInput("there is no layer of voxels along z; take at least 1");
    require_voxel_limits(counts);
}

}  // namespace

VoxelCounts default_voxels(const Lattice& lattice, double n_cells) {
    const Vec2 periods = axis_periods(lattice);
    const double side = std::sqrt(periods.x() * periods.y() / n_cells) / kVoxelsAlongCell;
    return {even_voxel_count(periods.x() / side), even_voxel_count(periods.y() / side)};
}

VoxelGrid voxel_grid(const Lattice& lattice, const Vec2& origin, VoxelCounts counts) {
    const Vec2 periods = axis_periods(lattice);
    require_counts(counts);
    const Domain domain(lattice, origin);
    return {.corner = domain.corner().cwiseMin(domain.opposite_corner()),
            .size = periods,
            .counts = counts};
}

}  // namespace pcvt::plane
