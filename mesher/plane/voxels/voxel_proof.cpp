#include "mesher/plane/voxels/voxel_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/torus/site_tree.hpp"

namespace pcvt::plane {
namespace {

/// Roundings of a coordinate on its way into a file and into a distance.
constexpr double kUlps = 8;
/// The largest difference of a lattice coordinate of a period from an integer.
constexpr double kWholePeriod = 1e-9;

std::string voxel_name(const VoxelGrid& grid, std::size_t index) {
    const auto width = static_cast<std::size_t>(grid.counts.x);
    return "voxel " + std::to_string(index % width) + "," + std::to_string(index / width);
}

void require_periods(const VoxelGrid& grid, const Lattice& lattice) {
    for (const Vec2& period : {Vec2(grid.size.x(), 0), Vec2(0, grid.size.y())}) {
        const Vec2 u = lattice.to_lattice(period);
        const Vec2 off = (u - Vec2(std::round(u.x()), std::round(u.y()))).cwiseAbs();
        if (off.maxCoeff() <= kWholePeriod) continue;
        throw NotATile("the periods of the voxels are not those of the sites");
    }
}

}  // namespace

void require_voxel_ids(const VoxelImage& image, int n_cells) {
    pcvt::require_voxel_ids(image.site, n_cells,
                            [&](std::size_t voxel) { return voxel_name(image.grid, voxel); });
}

VoxelProof prove_voxels(const VoxelImage& image, const VoxelCells& cells) {
    require_voxel_ids(image, cells.n_cells());
    const VoxelGrid& grid = image.grid;
    require_periods(grid, cells.lattice);
    // Distances are Euclidean in the plane of the metric.
    const Lattice round = cells.metric.to_round(cells.lattice);
    const SiteTree tree(round, cells.metric.to_round(cells.sites), cells.weights);
    const double h = std::sqrt(cells.lattice.area() / cells.n_cells());
    const double farthest = (grid.corner.cwiseAbs() + grid.size).maxCoeff();
    // The rounding of a position, in the plane of the metric.
    const double rounding =
        kUlps * std::numeric_limits<double>::epsilon() * farthest * cells.metric.largest_stretch();
    const Vec2 spacing = grid.spacing();
    double largest = 0;
    for (std::size_t k = 0; k < image.site.size(); ++k) {
        checkpoint_each(static_cast<long>(k));
        const auto width = static_cast<std::size_t>(grid.counts.x);
        const std::size_t row = k / width;
        const Vec2 step(double(k % width) + 0.5, double(row) + 0.5);
        const Vec2 p = cells.metric.to_round(Vec2(grid.corner + step.cwiseProduct(spacing)));
        const auto nearest = tree.nearest(p);
        if (nearest.site == image.site[k]) continue;
        const auto named = tree.nearest_of(image.site[k], p);
        // gap / apart is the distance of the centre from the line of equal power distance. Rounding
        // of the sites moves that line farther than the sites where these are close to each other.
        const double gap = (named.power_distance() - nearest.power_distance()) / 2;
        const double apart = (named.from_point - nearest.from_point).norm();
        const double reach = named.from_point.norm() + nearest.from_point.norm();
        if (!(gap <= kVoxelTolerance * h * apart + rounding * reach)) {
            throw NotATile(voxel_name(grid, k) + " names cell " + std::to_string(image.site[k]) +
                           ", but its centre lies in cell " + std::to_string(nearest.site));
        }
        if (apart > 0) largest = std::max(largest, gap / apart);
    }
    return {.n_cells = cells.n_cells(),
            .unseen = unseen_cells(image.site, cells.n_cells()),
            .largest_excess = largest / h};
}

}  // namespace pcvt::plane
