// The page and the npm package offer no tetrahedra inside of cells, so that the module stays small:
// this function takes the place of that of mesher/space/grains, which is then not linked.
#include "mesher/space/grains/grains.hpp"

namespace pcvt::space {

Grains mesh_grains(const Sites& /*sites*/, const CellComplex& /*complex*/,
                   const GrainChoices& /*choices*/, const Vec3& /*origin*/) {
    throw LimitExceeded(
        "WebAssembly has no tetrahedra inside of cells; take the command, C or Python");
}

}  // namespace pcvt::space
