#include "mesher/space_cvt/space_minimum.hpp"

#include "mesher/optimize/inertia.hpp"
#include "mesher/space_cvt/space_hessian.hpp"

namespace pcvt {
namespace {

constexpr int kTranslations = 3;

}  // namespace

Minimum space_minimum(const SpaceDelaunay& delaunay) {
    const auto& [sites, tetrahedra] = delaunay;
    if (sites.n_sites() == 1) return Minimum::kYes;
    BlockMatrix hessian;
    assemble_space_hessian(tetrahedra, sites.coordinates(),
                           SpaceFrame(sites.reduction().reduced, sites.spacing()), hessian);
    return minimum_by_inertia(hessian, kTranslations);
}

}  // namespace pcvt
