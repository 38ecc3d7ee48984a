#include <array>

#include "tests/mutants/mutated_formats.hpp"
#include "tests/mutants/xml_namer.hpp"

namespace pcvt::testing {
namespace {}  // namespace

std::vector<Mutant> vtu_mutants(const BaseFile& base) {
    return text_mutants(base.files, 0, XmlNamer(), kXmlSeparators, kDigit);
}

std::span<const Harmless> harmless_in_vtu() {
    static constexpr std::array kHarmless{
        Harmless{"PhaseNames*", "", "the names of the phases are the user's words, stated once"},
        Harmless{"HoleNames*", "", "the names of the holes are the user's words, stated once"},
        Harmless{"Orbit Name*", "", kNoOrbits},
        Harmless{"Orbit value", "+1", kOwnOrbit, "voronoi symmetric"},
        Harmless{"Orbit value", "", kStatedOrbits, "delaunay"},
        Harmless{"Orbit value", "", kStatedOrbits, "grains"},
        Harmless{"Orbit row", "", kStatedOrbits, "delaunay"},
        Harmless{"Orbit row", "", kStatedOrbits, "grains"},
        Harmless{"SiteWeights*", "", kNotShown, "delaunay"},
        Harmless{"SiteWeights*", "", kNotShown, "grains"},
        Harmless{"Metric*", "", kNotShown, "delaunay"},
        Harmless{"Metric*", "", kNotShown, "grains"},
        Harmless{"VTKFile *", "", "the versions of the format do not differ in what it uses"},
        Harmless{"ShortEdges value", "",
                 "a longer bound of the removed edges, which only the proof reads"},
        Harmless{"Points Name*", "", "VTK finds the points by their element"},
        Harmless{"Points value", "", "a node inside of a grain; the mesh is another one", "grains"},
        Harmless{"connectivity row", "swap", "the order of the elements of one cell"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
