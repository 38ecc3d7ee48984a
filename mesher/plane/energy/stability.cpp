#include "mesher/plane/energy/stability.hpp"

#include "mesher/optimize/inertia.hpp"
#include "mesher/plane/energy/hessian.hpp"

namespace pcvt::plane {
namespace {

constexpr int kTranslations = 2;

}  // namespace

Minimum stability(const BlockMatrix& hessian) {
    return hessian.n_rows() == 1 ? Minimum::kYes : minimum_by_inertia(hessian, kTranslations);
}

Minimum stability(const Sites& sites) {
    MovingDelaunay delaunay(sites);
    Workers workers(1);
    BlockMatrix hessian;
    assemble_hessian(delaunay, workers, hessian);
    return stability(hessian);
}

}  // namespace pcvt::plane
