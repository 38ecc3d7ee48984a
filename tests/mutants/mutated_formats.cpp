#include "tests/mutants/mutated_formats.hpp"

#include <array>

namespace pcvt::testing {

std::span<const MutatedFormat> mutated_formats() {
    static const std::array kFormats{
        MutatedFormat{".obj", obj_mutants, harmless_in_obj()},
        MutatedFormat{".ply", ply_mutants, harmless_in_ply()},
        MutatedFormat{".glb", glb_mutants, harmless_in_gltf()},
        MutatedFormat{".gltf", gltf_mutants, harmless_in_gltf()},
        MutatedFormat{".om", om_mutants, harmless_in_om()},
        MutatedFormat{".msh", msh_mutants, harmless_in_msh()},
        MutatedFormat{".inp", inp_mutants, harmless_in_inp()},
        MutatedFormat{".vtu", vtu_mutants, harmless_in_vtu()},
        MutatedFormat{".foam", foam_mutants, harmless_in_foam()},
        MutatedFormat{".nc", nc_mutants, harmless_in_nc()},
        MutatedFormat{".vti", vti_mutants, harmless_in_vti()},
    };
    return kFormats;
}

}  // namespace pcvt::testing
