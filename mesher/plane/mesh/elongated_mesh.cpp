#include "mesher/plane/mesh/elongated_mesh.hpp"

namespace pcvt::plane {

PeriodicMesh from_round(PeriodicMesh mesh, const Metric& metric, const Lattice& lattice) {
    mesh.lattice = lattice;
    for (Vec2& p : mesh.vertices) p = metric.from_round(p);
    for (Vec2& p : mesh.site_points) p = metric.from_round(p);
    return mesh;
}

}  // namespace pcvt::plane
