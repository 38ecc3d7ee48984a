#include <array>

#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {

std::span<const Harmless> harmless_in_space() {
    static constexpr std::array kHarmless{
        Harmless{"VTKFile *", "", "the versions of the format do not differ in what it uses"},
    };
    return kHarmless;
}

std::span<const Harmless> harmless_in_space_glb() {
    static constexpr std::array kHarmless{
        Harmless{"asset.generator", "", "a file of another program proves less"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
