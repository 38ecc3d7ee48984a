#include "mesher/space/space_delaunay.hpp"

#include "mesher/space/orbit_insertion.hpp"
#include "mesher/space/site_insertion.hpp"
#include "mesher/space/space_mirrors.hpp"

namespace pcvt {

TorusTetrahedra space_tetrahedra(const SpaceSites& sites) {
    if (auto inserted = inserted_tetrahedra(sites)) return *std::move(inserted);
    if (auto inserted = orbit_tetrahedra(sites)) return *std::move(inserted);
    return {sites.n_sites(), space_mirrors(sites).tetrahedra};
}

SpaceDelaunay space_delaunay(const SpaceSites& sites) { return {sites, space_tetrahedra(sites)}; }

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
