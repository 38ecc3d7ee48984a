#include <array>

#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {

namespace {

constexpr std::string_view kLongerBound =
    "another bound of the removed edges, which only the proof reads";
constexpr std::string_view kUserWords = "the names of the phases are the user's words, stated once";
constexpr std::string_view kSameColour =
    "another orientation with the same colour in the pole figure";
constexpr std::string_view kStatedOnce = "orientations that no colours show are stated once";
constexpr std::string_view kMovedCorners = "less than the distance by which corners were moved";

}  // namespace

std::span<const Harmless> harmless_in_space() {
    static constexpr std::array kHarmless{
        Harmless{"lattice", "", "another basis of the same lattice", "cells octahedra"},
        Harmless{"alone lattice", "", "another basis of the same lattice", "cells octahedra"},
        Harmless{"site row", "duplicate", "one site more, behind no face of the boundary",
                 "boundary"},
        Harmless{"alone site row", "duplicate", "one site more, behind no face of the boundary",
                 "boundary"},
        Harmless{"lattice", "exchange", "another basis of the same lattice", "cells left-handed"},
        Harmless{"alone lattice", "exchange", "another basis of the same lattice",
                 "cells left-handed"},
        Harmless{"connectivity row", "swap", "the order of the tetrahedra", "tetrahedra"},
        Harmless{"connectivity row", "swap", "the order of the tetrahedra of a cell",
                 "materials of grains"},
        Harmless{"ShortEdges value", "", kLongerBound, "short"},
        Harmless{"pcvt short_edges", "", kLongerBound, "short"},
        Harmless{"Site value", "digit", kMovedCorners, "short"},
        Harmless{"pcvt site", "digit", kMovedCorners, "short"},
        // The third coordinate, where sites of the plane have their weight.
        Harmless{"pcvt weight", "digit", kMovedCorners, "short"},
        Harmless{"pcvt kind row", "duplicate", "says the same twice"},
        Harmless{"pcvt lattice row", "duplicate", "says the same twice"},
        Harmless{"pcvt", "", "without its only line the case states no site", "one"},
        Harmless{"pcvt site row", "delete", "without its only line the case states no site", "one"},
        Harmless{"site row", "delete", "without its only line the file states no site",
                 "boundary one"},
        Harmless{"alone site row", "delete", "without its only line the file states no site",
                 "boundary one"},
        Harmless{"$ElementData row", "swap", "the values have the numbers of their elements"},
        Harmless{"$NodeData row", "swap", "the values have the numbers of their nodes"},
        Harmless{"*NSET row", "swap", "a set has no order"},
        Harmless{"*NSET row", "duplicate", "a set has no repetitions"},
        Harmless{"*ELSET row", "swap", "a set has no order"},
        Harmless{"*ELSET row", "duplicate", "a set has no repetitions"},
        Harmless{"face.halfedge", "", "another halfedge of the face"},
        Harmless{"PhaseNames*", "", kUserWords, "materials"},
        Harmless{"Orientation value", "", kSameColour, "materials"},
        Harmless{"phases", "word", kUserWords, "materials"},
        Harmless{"phases", "word", kUserWords, "by phase"},
        Harmless{"angles*", "", kStatedOnce, "materials"},
        Harmless{"alone angles*", "", kStatedOnce, "materials"},
        Harmless{"pcvt angles*", "", kStatedOnce, "materials"},
        Harmless{"angles*", "", kSameColour, "by orientation"},
        Harmless{"alone angles*", "", kSameColour, "by orientation"},
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
        Harmless{"nodes.extras.periodic.lattice", "", "another basis of the same lattice",
                 "cells left-handed"},
        Harmless{"nodes.extras.periodic.lattice row", "swap", "another basis of the same lattice",
                 "cells"},
        Harmless{"nodes.extras.periodic.lattice row", "swap", "another basis of the same lattice",
                 "materials"},
        Harmless{"nodes.extras.periodic.lattice row", "swap", "another basis of the same lattice",
                 "by "},
        Harmless{"nodes.extras.periodic.lattice row", "swap", "another basis of the same lattice",
                 "power"},
        Harmless{"nodes.extras.periodic.orientations*", "", kStatedOnce, "materials"},
        Harmless{"nodes.extras.periodic.orientations*", "", kSameColour, "by orientation"},
        Harmless{"meshes.primitives.material", "", "colours that only tell neighbours apart",
                 "by cells"},
        Harmless{"NORMAL.x", "digit", kSingle},
        Harmless{"NORMAL.y", "digit", kSingle},
        Harmless{"NORMAL.z", "digit", kSingle},
        Harmless{"NORMAL.z", "exchange", "neighbours that differ below the rounding"},
        Harmless{"NORMAL.x", "sign", "a component below the rounding"},
        Harmless{"NORMAL.y", "sign", "a component below the rounding"},
        Harmless{"NORMAL.z", "sign", "a component below the rounding"},
        Harmless{"nodes.extras.periodic.sites*", "",
                 "the sites behind a boundary, which its triangles do not name", "boundary"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
