#include "mesher/space/voxels/voxel_proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/torus/site_tree.hpp"

namespace pcvt::space {
namespace {

/// Roundings of a coordinate on its way into a file and into a distance.
constexpr double kUlps = 8;
/// The largest difference of a lattice coordinate of a period from an integer.
constexpr double kWholePeriod = 1e-9;
/// The box along the axes round the image of a box is at most this times as wide as the largest
/// stretch makes it: the root of 3.
constexpr double kWidestBox = 1.7320508075688772;
/// Voxels along an edge of a block, for which the nearest sites are searched together.
constexpr int kVoxelsOfABlock = 8;

std::string voxel_name(const VoxelGrid& grid, std::size_t index) {
    const auto width = static_cast<std::size_t>(grid.counts.x);
    const auto depth = static_cast<std::size_t>(grid.counts.y);
    return "voxel " + std::to_string(index % width) + "," + std::to_string(index / width % depth) +
           "," + std::to_string(index / width / depth);
}

void require_periods(const VoxelGrid& grid, const Lattice& lattice) {
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 period = Vec3::Zero();
        period[axis] = grid.size[axis];
        const Vec3 u = lattice.to_lattice(period);
        const Vec3 off = (u.array() - u.array().round()).abs();
        if (off.maxCoeff() <= kWholePeriod) continue;
        throw NotATile("the periods of the voxels are not those of the sites");
    }
}

/// Proves the voxels of a grid, block by block.
class BlockProof {
   public:
    BlockProof(const VoxelImage& image, const VoxelCells& cells)
        : image_(image),
          counts_{image.grid.counts.x, image.grid.counts.y, image.grid.counts.z},
          spacing_(image.grid.spacing()),
          metric_(cells.metric),
          tree_(metric_.to_round(cells.lattice), metric_.to_round(cells.sites), cells.weights),
          h_(cells.lattice.spacing(cells.n_cells())),
          rounding_(kUlps * std::numeric_limits<double>::epsilon() *
                    (image.grid.corner.cwiseAbs() + image.grid.size).maxCoeff() *
                    metric_.largest_stretch()) {
        // A block is at most as wide as the domain, in the metric too.
        const double narrowest =
            reduce(metric_.to_round(cells.lattice)).reduced.heights().minCoeff() /
            (metric_.is_round() ? 1 : kWidestBox * metric_.largest_stretch());
        for (int d = 0; d < 3; ++d) {
            const double most = std::floor(narrowest / spacing_[d]);
            sides_[d] = static_cast<int>(std::clamp<double>(most, 1, kVoxelsOfABlock));
        }
    }

    /// @returns the largest distance of a centre from its cell, length units.
    double prove_all() {
        std::array<int, 3> begin{};
        for (begin[2] = 0; begin[2] < counts_[2]; begin[2] += sides_[2]) {
            for (begin[1] = 0; begin[1] < counts_[1]; begin[1] += sides_[1]) {
                for (begin[0] = 0; begin[0] < counts_[0]; begin[0] += sides_[0]) prove(begin);
            }
        }
        return largest_;
    }

   private:
    void prove(const std::array<int, 3>& begin) {
        checkpoint();
        std::array<int, 3> end;
        Vec3 middle;
        Vec3 half;
        for (int d = 0; d < 3; ++d) {
            end[d] = std::min(begin[d] + sides_[d], counts_[d]);
            middle[d] = (begin[d] + end[d]) / 2.0 * spacing_[d];
            half[d] = (end[d] - begin[d] - 1) / 2.0 * spacing_[d];
        }
        const std::vector<NearestImage<3>> images = tree_.nearest_in_box(
            metric_.to_round(Vec3(image_.grid.corner + middle)), metric_.box_to_round(half));
        for (int m = begin[2]; m < end[2]; ++m) {
            for (int l = begin[1]; l < end[1]; ++l) {
                for (int k = begin[0]; k < end[0]; ++k) {
                    const Vec3 step(k + 0.5, l + 0.5, m + 0.5);
                    const std::size_t row = static_cast<std::size_t>(m) * counts_[1] + l;
                    prove_voxel(row * counts_[0] + k, middle,
                                metric_.to_round(Vec3(step.cwiseProduct(spacing_) - middle)),
                                images);
                }
            }
        }
    }

    /// @param from_middle  the centre of the voxel as seen from the middle of its block, in the
    ///                     round space.
    void prove_voxel(std::size_t voxel, const Vec3& middle, const Vec3& from_middle,
                     const std::vector<NearestImage<3>>& images) {
        const auto from_centre = [&](NearestImage<3> image) {
            image.from_point -= from_middle;
            return image;
        };
        NearestImage<3> nearest = from_centre(images.front());
        for (const NearestImage<3>& image : images) {
            const NearestImage<3> other = from_centre(image);
            if (other.power_distance() < nearest.power_distance()) nearest = other;
        }
        const SiteId name = image_.site[voxel];
        if (nearest.site == name) return;
        const NearestImage<3> named = tree_.nearest_of(
            name, metric_.to_round(Vec3(image_.grid.corner + middle)) + from_middle);
        // gap / apart is the distance of the centre from the plane of equal power distance.
        // Rounding of the sites moves that plane farther than the sites where these are close.
        const double gap = (named.power_distance() - nearest.power_distance()) / 2;
        const double apart = (named.from_point - nearest.from_point).norm();
        const double reach = named.from_point.norm() + nearest.from_point.norm();
        if (!(gap <= kVoxelTolerance * h_ * apart + rounding_ * reach)) {
            throw NotATile(voxel_name(image_.grid, voxel) + " names cell " + std::to_string(name) +
                           ", but its centre lies in cell " + std::to_string(nearest.site));
        }
        if (apart > 0) largest_ = std::max(largest_, gap / apart);
    }

    const VoxelImage& image_;
    std::array<int, 3> counts_;
    Vec3 spacing_;
    Metric metric_;
    SiteTree<Lattice> tree_;
    double h_;
    /// The rounding of a position.
    double rounding_;
    std::array<int, 3> sides_;
    double largest_ = 0;
};

}  // namespace

void require_voxel_ids(const VoxelImage& image, int n_cells) {
    pcvt::require_voxel_ids(image.site, n_cells,
                            [&](std::size_t voxel) { return voxel_name(image.grid, voxel); });
}

VoxelProof prove_voxels(const VoxelImage& image, const VoxelCells& cells) {
    require_voxel_ids(image, cells.n_cells());
    require_periods(image.grid, cells.lattice);
    const double largest = BlockProof(image, cells).prove_all();
    return {.n_cells = cells.n_cells(),
            .unseen = unseen_cells(image.site, cells.n_cells()),
            .largest_excess = largest / cells.lattice.spacing(cells.n_cells())};
}

}  // namespace pcvt::space
