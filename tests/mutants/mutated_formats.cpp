#include "tests/mutants/mutated_formats.hpp"

#include <array>

#include "tests/mutants/space_bases.hpp"

namespace pcvt::testing {

std::span<const MutatedFormat> mutated_formats() {
    static const std::array kFormats{
        MutatedFormat{"obj", ".obj", base_files, refusal, obj_mutants, harmless_in_obj()},
        MutatedFormat{"ply", ".ply", base_files, refusal, ply_mutants, harmless_in_ply()},
        MutatedFormat{"glb", ".glb", base_files, refusal, glb_mutants, harmless_in_gltf()},
        MutatedFormat{"gltf", ".gltf", base_files, refusal, gltf_mutants, harmless_in_gltf()},
        MutatedFormat{"om", ".om", base_files, refusal, om_mutants, harmless_in_om()},
        MutatedFormat{"msh", ".msh", base_files, refusal, msh_mutants, harmless_in_msh()},
        MutatedFormat{"inp", ".inp", base_files, refusal, inp_mutants, harmless_in_inp()},
        MutatedFormat{"vtu", ".vtu", base_files, refusal, vtu_mutants, harmless_in_vtu()},
        MutatedFormat{"foam", ".foam", base_files, refusal, foam_mutants, harmless_in_foam()},
        MutatedFormat{"nc", ".nc", base_files, refusal, nc_mutants, harmless_in_nc()},
        MutatedFormat{"vti", ".vti", base_files, refusal, vti_mutants, harmless_in_vti()},
        MutatedFormat{"space_vti", ".vti", space_base_files, refusal, vti_mutants,
                      harmless_in_vti()},
        MutatedFormat{"space_vtu", ".vtu", space_base_files, space_refusal, vtu_mutants,
                      harmless_in_space()},
        MutatedFormat{"space_foam", ".foam", space_base_files, space_refusal, foam_mutants,
                      harmless_in_space()},
        MutatedFormat{"space_msh", ".msh", space_base_files, space_refusal, msh_mutants,
                      harmless_in_space()},
        MutatedFormat{"space_inp", ".inp", space_base_files, space_refusal, inp_mutants,
                      harmless_in_space()},
        MutatedFormat{"space_obj", ".obj", space_base_files, space_refusal, obj_mutants,
                      harmless_in_space()},
        MutatedFormat{"space_ply", ".ply", space_base_files, space_refusal, ply_mutants,
                      harmless_in_space()},
        MutatedFormat{"space_glb", ".glb", space_base_files, space_refusal, glb_mutants,
                      harmless_in_space_glb()},
        MutatedFormat{"space_om", ".om", space_base_files, space_refusal, om_mutants,
                      harmless_in_space()},
        MutatedFormat{"space_stl", ".stl", space_base_files, space_refusal, stl_mutants,
                      harmless_in_stl()},
    };
    return kFormats;
}

}  // namespace pcvt::testing
