#include "mesher/space/mesh/tetrahedral_mesh.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

#include "mesher/base/checkpoint.hpp"
#include "mesher/space/mesh/tile_ties.hpp"

namespace pcvt::space {
namespace {

/// Chooses one image of each tetrahedron.
class TileGrowth {
   public:
    TileGrowth(const PeriodicDelaunay& delaunay, const Vec3& origin)
        : tetrahedra_(delaunay.tetrahedra),
          coordinates_(delaunay.sites.coordinates()),
          placed_(static_cast<std::size_t>(tetrahedra_.n_tetrahedra()), false),
          frames_(placed_.size()) {
        const Lattice& reduced = delaunay.sites.reduction().reduced;
        centre_ =
            reduced.to_lattice(origin + delaunay.sites.lattice().to_position(Vec3::Constant(0.5)));
    }

    /// Returns the offset of each tetrahedron from its own frame, in the reduced basis.
    std::vector<Offset> grow() {
        add_first();
        while (!queue_.empty()) {
            const auto [distance, t, frame] = queue_.top();
            queue_.pop();
            if (placed_[t]) continue;
            checkpoint_each(t);
            placed_[t] = true;
            frames_[t] = frame;
            for (int f = 4 * t; f < 4 * t + 4; ++f) {
                add(tetrahedra_.opposite(f) / 4, frame + tetrahedra_.frame_across(f));
            }
        }
        return std::move(frames_);
    }

   private:
    /// The distance of the barycentre of an image from the centre, the tetrahedron, its offset.
    using Candidate = std::tuple<double, int, Offset>;

    /// The barycentre in the tetrahedron's own frame, relative to the centre.
    Vec3 barycentre(int t) const {
        Vec3 sum = Vec3::Zero();
        for (const Corner& corner : tetrahedra_.tetrahedron(t)) {
            sum += image(coordinates_, corner).at;
        }
        return sum / 4 - centre_;
    }

    Candidate candidate(int t, Offset frame) const {
        return {(barycentre(t) + frame.vector()).lpNorm<Eigen::Infinity>(), t, frame};
    }

    void add(int t, Offset frame) {
        if (!placed_[t]) queue_.push(candidate(t, frame));
    }

    void add_first() {
        const auto nearest_image = [this](int t) {
            const Vec3 whole = barycentre(t).array().round();
            return candidate(t, {-static_cast<int>(whole.x()), -static_cast<int>(whole.y()),
                                 -static_cast<int>(whole.z())});
        };
        Candidate first = nearest_image(0);
        for (int t = 1; t < tetrahedra_.n_tetrahedra(); ++t) {
            first = std::min(first, nearest_image(t));
        }
        queue_.push(first);
    }

    const TorusTetrahedra& tetrahedra_;
    const Points& coordinates_;
    Vec3 centre_;
    std::vector<char> placed_;
    std::vector<Offset> frames_;
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

/// Appends the images as points: those of one site follow each other, and all but the first are
/// the first one plus a translation.
void append_points(TetrahedralMesh& mesh, const Sites& sites, const std::vector<Corner>& images) {
    Corner first{-1, {}};
    Vec3 position = Vec3::Zero();
    for (const Corner& corner : images) {
        if (corner.site != first.site) {
            first = corner;
            position = sites.position(corner.site) + mesh.lattice.translation(corner.offset);
        }
        const Offset offset = corner.offset - first.offset;
        mesh.points.push_back(position + mesh.lattice.translation(offset));
        mesh.point_site.push_back(corner.site);
        mesh.point_offset.push_back(offset);
    }
}

}  // namespace

TetrahedralMesh tetrahedral_mesh(const PeriodicDelaunay& delaunay, const Vec3& origin) {
    // One image of each tetrahedron, with offsets in the given basis.
    const std::vector<Offset> frames = tied_frames(delaunay, TileGrowth(delaunay, origin).grow());
    std::vector<Tetrahedron> placed;
    std::vector<Corner> images;
    for (int t = 0; t < delaunay.tetrahedra.n_tetrahedra(); ++t) {
        placed.push_back(delaunay.tetrahedra.tetrahedron(t));
        for (Corner& corner : placed.back()) {
            corner.offset = delaunay.sites.reduction().to_original(corner.offset + frames[t]);
            images.push_back(corner);
        }
    }
    // Each image becomes one point.
    std::sort(images.begin(), images.end());
    images.erase(std::unique(images.begin(), images.end()), images.end());
    TetrahedralMesh mesh{.lattice = delaunay.sites.lattice()};
    append_points(mesh, delaunay.sites, images);
    for (const Tetrahedron& corners : placed) {
        std::array<int, 4>& points = mesh.tetrahedra.emplace_back();
        std::transform(corners.begin(), corners.end(), points.begin(), [&](const Corner& corner) {
            const auto found = std::lower_bound(images.begin(), images.end(), corner);
            return static_cast<int>(found - images.begin());
        });
    }
    return mesh;
}

}  // namespace pcvt::space
