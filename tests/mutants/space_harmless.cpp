#include <array>

#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {

std::span<const Harmless> harmless_in_space() {
    static constexpr std::array kHarmless{
        Harmless{"lattice", "", "another basis of the same lattice", "cells octahedra"},
        Harmless{"alone lattice", "", "another basis of the same lattice", "cells octahedra"},
        Harmless{"site row", "duplicate", "one site more, behind no face of the boundary",
                 "boundary"},
        Harmless{"alone site row", "duplicate", "one site more, behind no face of the boundary",
                 "boundary"},
        Harmless{"pcvt kind row", "duplicate", "says the same twice"},
        Harmless{"pcvt", "", "without its only line the case states no site", "one"},
        Harmless{"alone mtllib*", "", "the material file is missing"},
        Harmless{"alone usemtl*", "", "the material file is missing"},
    };
    return kHarmless;
}

std::span<const Harmless> harmless_in_space_glb() {
    static constexpr std::array kHarmless{
        Harmless{"asset.generator", "", "a file of another program proves less"},
        Harmless{"nodes.extras.periodic.lattice", "", "another basis of the same lattice",
                 "cells octahedra"},
        Harmless{"nodes.extras.periodic.lattice row", "swap", "another basis of the same lattice",
                 "cells"},
        Harmless{"NORMAL.x", "digit", kSingle},
        Harmless{"NORMAL.y", "digit", kSingle},
        Harmless{"NORMAL.z", "digit", kSingle},
        Harmless{"NORMAL.x", "sign", "a component below the rounding"},
        Harmless{"NORMAL.y", "sign", "a component below the rounding"},
        Harmless{"NORMAL.z", "sign", "a component below the rounding"},
        Harmless{"nodes.extras.periodic.sites*", "",
                 "the sites behind a boundary, which its triangles do not name", "boundary"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
