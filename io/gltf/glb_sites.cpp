#include "io/gltf/glb_sites.hpp"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "io/gltf/glb_faces.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/mesh/cell_sites.hpp"

namespace pcvt {
namespace {

constexpr double kDoubleEpsilon = std::numeric_limits<double>::epsilon();

/// Points of the torus, found by their position.
class PointImages {
   public:
    PointImages(const space::Lattice& lattice, space::Points points)
        : lattice_(lattice), points_(std::move(points)) {
        for (int k = 0; k < points_.cols(); ++k) {
            const space::Vec3 u = lattice.to_lattice(points_.col(k));
            sorted_.emplace(u.x() - std::floor(u.x()), k);
        }
    }

    /// Whether an image of a point k lies within `distance` of a point, and accept(k, translation)
    /// holds for it.
    template <class Accept>
    bool any_at(const space::Vec3& point, double distance, const Accept& accept) const {
        const space::Vec3 u = lattice_.to_lattice(point);
        const double at = u.x() - std::floor(u.x());
        // The first lattice coordinate changes by at most this much.
        const space::Vec3 across = lattice_.b().cross(lattice_.c());
        const double width = distance * across.norm() / lattice_.volume() + 4 * kDoubleEpsilon;
        return std::any_of(kTurns.begin(), kTurns.end(), [&](double turn) {
            auto found = sorted_.lower_bound(at + turn - width);
            for (; found != sorted_.end() && found->first <= at + turn + width; ++found) {
                const space::Vec3 difference =
                    lattice_.to_lattice(point - points_.col(found->second));
                const space::Vec3 whole = difference.array().round();
                const bool is_near =
                    lattice_.to_position(space::Vec3(difference - whole)).norm() <= distance;
                if (is_near && accept(found->second, lattice_.to_position(whole))) return true;
            }
            return false;
        });
    }

   private:
    static constexpr std::array<double, 3> kTurns{-1, 0, 1};

    const space::Lattice& lattice_;
    space::Points points_;
    std::multimap<double, int> sorted_;
};

/// A face of a cell, and the site of the cell.
struct FaceAtSite {
    FaceSize face;
    space::Vec3 normal;
    space::Vec3 site;
    /// The largest error of its direction.
    double tilt;

    FaceAtSite(const GlbSurfaces& glb, int f, double off)
        : face(glb.list.surface.points, glb.list.surface.faces[f]),
          normal(stated_normal(glb, glb.list.surface.faces[f].front())),
          site(glb.list.surface.sites.col(glb.list.surface.cell[f])),
          tilt(kSingleEpsilon + face.tilt(off)) {}
};

/// The site of each cell, mirrored in a face of the cell, is a site.
void compare_voronoi_sites(const GlbSurfaces& glb, double largest, double off) {
    const space::TileSurface& surface = glb.list.surface;
    const PointImages images(surface.lattice, surface.sites);
    for (int f = 0; f < surface.n_faces(); ++f) {
        checkpoint_each(f);
        const FaceAtSite at(glb, f, off);
        const space::Vec3 arm = at.face.centre - at.site;
        const double height = arm.dot(at.normal);
        const double tolerance = 4 * (kSingleEpsilon * largest + at.tilt * arm.norm());
        // The rounding of corners may move a plane to the other side of a site near it.
        if (height > -tolerance && images.any_at(at.site + 2 * height * at.normal, tolerance,
                                                 [](int, const space::Vec3&) { return true; })) {
            continue;
        }
        throw_violation(kSiteLaw, "the site of " + glb.groups[surface.cell[f]].name +
                                      ", mirrored in a face of its cell, is not a site");
    }
}

/// Each face has another one at its place, turned over, and both lie in the plane that the sites
/// and the weights of their cells give, or in which a box cuts one cell.
void compare_power_sites(const GlbSurfaces& glb, double largest, double off) {
    const space::TileSurface& surface = glb.list.surface;
    const Eigen::VectorXd weights = glb.list.weights.size() > 0
                                        ? glb.list.weights
                                        : Eigen::VectorXd::Zero(surface.sites.cols());
    space::Points centres(3, surface.n_faces());
    for (int f = 0; f < surface.n_faces(); ++f) {
        centres.col(f) = FaceSize(surface.points, surface.faces[f]).centre;
    }
    const PointImages images(surface.lattice, centres);
    for (int f = 0; f < surface.n_faces(); ++f) {
        checkpoint_each(f);
        const FaceAtSite at(glb, f, off);
        const space::Vec3 arm = at.face.centre - at.site;
        const auto is_plane = [&](int g, const space::Vec3& translation) {
            if (stated_normal(glb, surface.faces[g].front()).dot(at.normal) > 0) return false;
            const space::Vec3 across = surface.sites.col(surface.cell[g]) + translation - at.site;
            const double tolerance =
                4 * (kSingleEpsilon * largest + at.tilt * (arm.norm() + across.norm()));
            // A box cuts a cell between two pieces with one site.
            if (across.norm() <= off) return true;
            const double sideways = (across - across.dot(at.normal) * at.normal).norm();
            const double balance = 2 * arm.dot(across) - across.squaredNorm() +
                                   weights[surface.cell[g]] - weights[surface.cell[f]];
            return sideways <= tolerance && std::abs(balance) <= 2 * across.norm() * tolerance;
        };
        if (images.any_at(at.face.centre, 4 * kSingleEpsilon * largest, is_plane)) continue;
        throw_violation(kSiteLaw, "a face of " + glb.groups[surface.cell[f]].name +
                                      " is not that of its site and its weight");
    }
}

}  // namespace

void compare_sites(const GlbSurfaces& glb, double largest) {
    const space::TileSurface& surface = glb.list.surface;
    const std::size_t n_cells = glb.groups.size();
    if (surface.sites.cols() != static_cast<Eigen::Index>(n_cells)) {
        throw_violation(kSiteLaw, "there are " + std::to_string(surface.sites.cols()) +
                                      " sites of " + std::to_string(n_cells) + " cells");
    }
    // Proved corners lie at most this far off the planes between sites.
    const double off =
        space::kBisectorTolerance * portable_cbrt(surface.lattice.volume() / double(n_cells));
    const bool are_whole = cells_of_pieces(surface.lattice, surface.sites).empty();
    if (glb.list.weights.size() == 0 && are_whole) {
        compare_voronoi_sites(glb, largest, off);
    } else {
        compare_power_sites(glb, largest, off);
    }
}

}  // namespace pcvt
