// Functions that the module leaves out, because neither the page nor the package offers them.

#include "io/solvers/inp_tetrahedra.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/cvt/centroid_cells.hpp"
#include "mesher/space/cvt/centroid_cells.hpp"
#include "mesher/space/grains/grains.hpp"

namespace pcvt {
namespace {

[[noreturn]] void refuse_centroids() {
    throw InvalidInput("this module does not find sites of centroids; take the command");
}

[[noreturn]] void refuse_solver_tetrahedra() {
    throw InvalidInput("this module has no .inp files in space; take the command");
}

}  // namespace

std::vector<EncodedFile> encode_tetrahedra_inp(const space::TetrahedralMesh& /*mesh*/,
                                               const FileOptions& /*options*/,
                                               const std::string& /*path*/) {
    refuse_solver_tetrahedra();
}

bool holds_inp_tetrahedra(const EncodedFile& inp) { return states_tetrahedra(inp.bytes); }

TetrahedralTile decode_inp_tetrahedra(const EncodedFile& /*inp*/) { refuse_solver_tetrahedra(); }

void compare_inp_tetrahedra(const EncodedFile& /*inp*/, const TetrahedralTile& /*tile*/) {
    refuse_solver_tetrahedra();
}

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
