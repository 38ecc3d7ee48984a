#include "io/forms/point_offsets.hpp"

#include "io/bytes/bad_file.hpp"

namespace pcvt {
namespace {

/// Offsets of points are below this, so that their numbers fit into an int.
constexpr double kMostPointPeriods = 1 << 30;

}  // namespace

void find_point_offsets(const std::string& name, space::TetrahedralMesh& mesh) {
    const std::vector<int> first = first_points(mesh);
    for (int v = 0; v < mesh.n_points(); ++v) {
        const space::Vec3 u =
            mesh.lattice.to_lattice(mesh.points[v] - mesh.points[first[v]]).array().round();
        if (!(u.lpNorm<Eigen::Infinity>() < kMostPointPeriods)) {
            throw BadFile(name + ": node " + std::to_string(v + 1) +
                          " lies too far from its image; correct its position");
        }
        mesh.point_offset.push_back(
            {static_cast<int>(u.x()), static_cast<int>(u.y()), static_cast<int>(u.z())});
    }
}

std::vector<int> first_points(const space::TetrahedralMesh& mesh) {
    std::vector<int> of_site(mesh.points.size(), -1);
    std::vector<int> first;
    for (int v = 0; v < mesh.n_points(); ++v) {
        int& point = of_site[mesh.point_site[v]];
        if (point < 0) point = v;
        first.push_back(point);
    }
    return first;
}

}  // namespace pcvt
