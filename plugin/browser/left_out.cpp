// Functions that the module leaves out, because neither the page nor the package offers them.

#include "mesher/base/error.hpp"
#include "mesher/plane/cvt/centroid_cells.hpp"
#include "mesher/space/cvt/centroid_cells.hpp"
#include "mesher/space/grains/grains.hpp"

namespace pcvt {
namespace {

[[noreturn]] void refuse_centroids() {
    throw InvalidInput("this module does not find sites of centroids; take the command");
}

}  // namespace

plane::CentroidCells plane::fit_areas_and_centroids(const Lattice& /*lattice*/,
                                                    const Points& /*centroids*/,
                                                    const AreaCvtOptions& /*options*/) {
    refuse_centroids();
}

space::CentroidCells space::fit_volumes_and_centroids(const Lattice& /*lattice*/,
                                                      const Points& /*centroids*/,
                                                      const VolumeCvtOptions& /*options*/) {
    refuse_centroids();
}

space::Grains space::mesh_grains(const Sites& /*sites*/, const CellComplex& /*complex*/,
                                 const GrainChoices& /*choices*/, Workers& /*workers*/,
                                 const Vec3& /*origin*/) {
    throw InvalidInput("this module has no tetrahedra inside of cells; take the command");
}

}  // namespace pcvt
