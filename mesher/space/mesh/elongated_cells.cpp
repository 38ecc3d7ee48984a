#include "mesher/space/mesh/elongated_cells.hpp"

namespace pcvt::space {

CellComplex from_round(CellComplex complex, const Metric& metric, const Sites& sites) {
    complex.reduced = sites.reduction().reduced;
    for (Vec3& vertex : complex.vertices) vertex = metric.from_round(vertex);
    for (SiteId s = 0; s < complex.n_cells; ++s) complex.sites[s] = sites.position(s);
    return complex;
}

PolyhedralMesh to_round(PolyhedralMesh mesh) {
    for (Vec3& point : mesh.points) point = mesh.metric.to_round(point);
    for (FiniteVolumePatch& patch : mesh.patches) {
        patch.separation = mesh.metric.to_round(Vec3(patch.separation));
    }
    mesh.lattice = mesh.metric.to_round(mesh.lattice);
    mesh.metric = {};
    return mesh;
}

}  // namespace pcvt::space
