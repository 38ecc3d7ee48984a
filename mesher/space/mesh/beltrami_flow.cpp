#include "mesher/space/mesh/beltrami_flow.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "mesher/base/checkpoint.hpp"
#include "mesher/portable/portable_angles.hpp"

namespace pcvt::space {
namespace {

/// Reciprocal vectors whose lengths differ by less than this factor count as equally long.
constexpr double kEqual = 1 + 1e-9;

}  // namespace

BeltramiFlow::BeltramiFlow(const Lattice& lattice) {
    const Lattice reduced = reduce(lattice).reduced;
    Eigen::Matrix3d periods;
    for (int k = 0; k < 3; ++k) periods.col(k) = reduced.periods()[k];
    const Eigen::Matrix3d reciprocal = 2 * std::numbers::pi * periods.inverse();
    const double shortest = reciprocal.rowwise().norm().minCoeff();
    for (int r = 0; r < 3; ++r) {
        const Vec3 k = reciprocal.row(r);
        if (k.norm() > kEqual * shortest) continue;
        const Vec3 e = k.unitOrthogonal();
        waves_.push_back({k, e, k.normalized().cross(e)});
    }
    rate_ = shortest * shortest;
}

Vec3 BeltramiFlow::velocity(const Vec3& p) const {
    Vec3 sum = Vec3::Zero();
    for (const Wave& wave : waves_) {
        const auto [cos, sin] = cos_sin(wave.k.dot(p));
        sum += wave.e * cos + wave.f * sin;
    }
    return sum / static_cast<double>(waves_.size());
}

double BeltramiFlow::turn_time() const { return std::numbers::pi / 2 / std::sqrt(rate_); }

double courant_rate(const BeltramiFlow& flow, const PolyhedralMesh& mesh,
                    const std::vector<CellBody>& bodies) {
    std::vector<double> fluxes(bodies.size(), 0);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        const auto corners = mesh.faces[f];
        const Vec3 first = mesh.points[corners[0]];
        Vec3 area = Vec3::Zero();
        Vec3 mean = Vec3::Zero();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec3 here = mesh.points[corners[k]] - first;
            area += here.cross(mesh.points[corners[(k + 1) % corners.size()]] - first) / 2;
            mean += here / static_cast<double>(corners.size());
        }
        const double flux = std::abs(flow.velocity(first + mean).dot(area));
        fluxes[mesh.owner[f]] += flux;
        if (f < mesh.n_inner_faces()) fluxes[mesh.neighbour[f]] += flux;
    }
    double largest = 0;
    for (std::size_t s = 0; s < bodies.size(); ++s) {
        largest = std::max(largest, fluxes[s] / 2 / bodies[s].volume);
    }
    return largest;
}

}  // namespace pcvt::space
