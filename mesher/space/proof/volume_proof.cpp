#include "mesher/space/proof/volume_proof.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_functions.hpp"
#include "mesher/space/mesh/cell_faces.hpp"
#include "mesher/space/mesh/cell_sites.hpp"

namespace pcvt::space {
namespace {

/// Roundings of weights, and of the heights that follow from them, add up in one volume.
constexpr double kWeightRoundings = 64;

double face_area(const PolyhedralMesh& mesh, int face) {
    const auto corners = mesh.faces[face];
    const Vec3 first = mesh.points[corners[0]];
    Vec3 twice = Vec3::Zero();
    for (std::size_t k = 2; k < corners.size(); ++k) {
        twice += (mesh.points[corners[k - 1]] - first).cross(mesh.points[corners[k]] - first);
    }
    return twice.norm() / 2;
}

/// How much the volume of each cell may change by rounding, length^3.
class VolumeDoubts {
   public:
    explicit VolumeDoubts(const StatedPolyhedra& polyhedra)
        : polyhedra_(polyhedra),
          of_power_(rounding_of_power_distances()),
          doubts_(Eigen::VectorXd::Zero(polyhedra.mesh.n_sites())) {
        const PolyhedralMesh& mesh = polyhedra.mesh;
        if (polyhedra.sites.cols() > 0) {
            for_each_side(mesh, polyhedra.sites, [&](int face, int across, const Vec3& other) {
                add(face, corner_distance(face, across, other));
            });
            return;
        }
        for (int f = 0; f < mesh.n_faces(); ++f) add(f, 0);
    }

    const Eigen::VectorXd& doubts() const { return doubts_; }

   private:
    double rounding_of_power_distances() const {
        const Eigen::VectorXd& weights = polyhedra_.weights;
        const double spacing =
            portable_cbrt(polyhedra_.mesh.lattice.volume() / polyhedra_.mesh.n_sites());
        if (weights.size() == 0) return 4 * spacing * polyhedra_.rounding;
        // A corner lies within `reach` of its sites.
        const double reach = spacing + std::sqrt(weights.maxCoeff() - weights.minCoeff());
        return 4 * reach * polyhedra_.rounding + kWeightRoundings *
                                                     std::numeric_limits<double>::epsilon() / 2 *
                                                     weights.cwiseAbs().maxCoeff();
    }

    /// The largest distance of a corner from the plane between its sites, and the shift of this
    /// plane by rounding.
    double corner_distance(int face, int across, const Vec3& other) const {
        const SitePlane plane = plane_between(polyhedra_.mesh.owner[face], across, other,
                                              polyhedra_.sites, polyhedra_.weights);
        double largest = 0;
        for (const int v : polyhedra_.mesh.faces[face]) {
            largest = std::max(largest, std::abs(plane.height(polyhedra_.mesh.points[v])));
        }
        return largest + of_power_ / (2 * plane.distance);
    }

    void add(int face, double distance) {
        const PolyhedralMesh& mesh = polyhedra_.mesh;
        const double moved =
            face_area(mesh, face) * (std::numbers::sqrt3 * polyhedra_.rounding + distance);
        doubts_[mesh.site_of(mesh.owner[face])] += moved;
        if (face < mesh.n_inner_faces()) doubts_[mesh.site_of(mesh.neighbour[face])] += moved;
    }

    const StatedPolyhedra& polyhedra_;
    double of_power_;
    Eigen::VectorXd doubts_;
};

}  // namespace

VolumeComparison compare_volumes(const StatedPolyhedra& polyhedra, const Eigen::VectorXd& wanted,
                                 double least) {
    const PolyhedralMesh& mesh = polyhedra.mesh;
    const std::vector<CellBody> bodies = cell_bodies(mesh);
    Eigen::VectorXd volumes = Eigen::VectorXd::Zero(mesh.n_sites());
    for (int p = 0; p < mesh.n_cells; ++p) volumes[mesh.site_of(p)] += bodies[p].volume;
    const VolumeDoubts rounding(polyhedra);
    const double mean = mesh.lattice.volume() / mesh.n_sites();
    VolumeComparison worst{.cell = -1, .volume = 0, .error = 0, .tolerance = least};
    for (int s = 0; s < mesh.n_sites(); ++s) {
        checkpoint_each(s);
        const double volume = volumes[s];
        const double error = std::abs(volume - wanted[s]) / mean;
        const double tolerance =
            std::max(least * std::max(1.0, wanted[s] / mean), rounding.doubts()[s] / mean);
        if (worst.cell >= 0 && error * worst.tolerance <= worst.error * tolerance) continue;
        worst = {.cell = s, .volume = volume, .error = error, .tolerance = tolerance};
    }
    return worst;
}

}  // namespace pcvt::space
