#include "mesher/space/space_delaunay.hpp"

#include "mesher/space/space_mirrors.hpp"

namespace pcvt {

SpaceDelaunay space_delaunay(const SpaceSites& sites) {
    return {sites, TorusTetrahedra(sites.n_sites(), space_mirrors(sites).tetrahedra)};
}

bool is_locally_delaunay(const TorusTetrahedra& tetrahedra, const Points3& coordinates,
                         const Gram3& gram, int facet) {
    const auto at = [&](const Corner3& corner) { return image(coordinates, corner); };
    const auto [p, q, r, s] = tetrahedra.tetrahedron(facet / 4);
    return !violates_delaunay(gram, at(p), at(q), at(r), at(s), at(tetrahedra.apex_across(facet)));
}

bool is_positive(const TorusTetrahedra& tetrahedra, const Points3& coordinates, int tetrahedron) {
    const auto at = [&](const Corner3& corner) { return image(coordinates, corner); };
    const auto [p, q, r, s] = tetrahedra.tetrahedron(tetrahedron);
    return orientation(at(p), at(q), at(r), at(s)) > 0;
}

}  // namespace pcvt
