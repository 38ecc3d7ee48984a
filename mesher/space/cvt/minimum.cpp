#include "mesher/space/cvt/minimum.hpp"

#include "mesher/optimize/inertia.hpp"
#include "mesher/space/cvt/hessian.hpp"

namespace pcvt::space {
namespace {

constexpr int kTranslations = 3;

}  // namespace

Minimum decided_minimum(const PeriodicDelaunay& delaunay) {
    const Sites& sites = delaunay.sites;
    if (sites.n_sites() == 1) return Minimum::kYes;
    BlockMatrix hessian;
    assemble_hessian(delaunay.tetrahedra, sites.coordinates(),
                     Frame(sites.reduction().reduced, sites.spacing()), hessian);
    return minimum_by_inertia(hessian, kTranslations);
}

std::optional<Minimum> minimum_of(const CvtResult& result) {
    const bool are_few = result.delaunay.sites.n_sites() <= kMostSitesForMinimum;
    if (result.run.stop != Stop::kConverged || !are_few) return {};
    return decided_minimum(result.delaunay);
}

}  // namespace pcvt::space
