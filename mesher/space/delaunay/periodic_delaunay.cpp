#include "mesher/space/delaunay/periodic_delaunay.hpp"

#include "mesher/space/delaunay/mirror_diagram.hpp"
#include "mesher/space/delaunay/orbit_insertion.hpp"
#include "mesher/space/delaunay/site_insertion.hpp"

namespace pcvt::space {

TorusTetrahedra torus_tetrahedra(const Sites& sites) {
    if (auto inserted = inserted_tetrahedra(sites)) return *std::move(inserted);
    if (auto inserted = orbit_tetrahedra(sites)) return *std::move(inserted);
    return {sites.n_sites(), mirror_diagram(sites).tetrahedra};
}

PeriodicDelaunay periodic_delaunay(const Sites& sites) { return {sites, torus_tetrahedra(sites)}; }

bool is_locally_delaunay(const TorusTetrahedra& tetrahedra, const Points& coordinates,
                         const Gram& gram, int facet) {
    const auto at = [&](const Corner& corner) { return image(coordinates, corner); };
    const auto [p, q, r, s] = tetrahedra.tetrahedron(facet / 4);
    return !violates_delaunay(gram, at(p), at(q), at(r), at(s), at(tetrahedra.apex_across(facet)));
}

bool is_positive(const TorusTetrahedra& tetrahedra, const Points& coordinates, int tetrahedron) {
    const auto at = [&](const Corner& corner) { return image(coordinates, corner); };
    const auto [p, q, r, s] = tetrahedra.tetrahedron(tetrahedron);
    return orientation(at(p), at(q), at(r), at(s)) > 0;
}

}  // namespace pcvt::space
