#include "mesher/energy/stability.hpp"

#include "mesher/energy/hessian.hpp"
#include "mesher/optimize/inertia.hpp"

namespace pcvt {
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

}  // namespace pcvt
