#include <algorithm>
#include <array>

#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {
namespace {

/// Names the words of an MSH file by their section, the number of words in their row and their
/// place in it.
class MshNamer {
   public:
    LineNames operator()(const std::vector<std::string_view>& words) {
        if (words.empty()) return {};
        if (words[0].starts_with('$')) {
            section_ = words[0].starts_with("$End") ? "" : std::string(words[0]);
            return {"", {"section"}};
        }
        // pcvt reads only comments that begin with its name.
        const bool is_comment = section_ == "$Comments";
        if (is_comment && words[0] != "pcvt") return {};
        const std::string part = is_comment ? "pcvt " + std::string(words[1]) : section_;
        LineNames names{.row = part + " row"};
        const std::string form = part + " " + std::to_string(std::min(words.size(), kMost)) + ".";
        for (std::size_t w = 0; w < words.size(); ++w) {
            names.words.push_back(form + std::to_string(std::min(w, kMost)));
        }
        return names;
    }

   private:
    static constexpr std::size_t kMost = 9;
    std::string section_;
};

constexpr std::string_view kNumberedRow = "each row states its element or node; Gmsh reorders them";

}  // namespace

std::vector<Mutant> msh_mutants(const BaseFile& base) {
    return text_mutants(base.files, 0, MshNamer(), "", kDigit);
}

std::span<const Harmless> harmless_in_msh() {
    static constexpr std::array kHarmless{
        Harmless{"pcvt site 5.4", "", kNotShown, "delaunay"},
        Harmless{"pcvt site 5.4", "", kNotShown, "grains"},
        Harmless{"pcvt metric*", "", kNotShown, "delaunay"},
        Harmless{"pcvt metric*", "", kNotShown, "grains"},
        Harmless{"$ElementData row", "swap", kNumberedRow},
        Harmless{"$NodeData row", "swap", kNumberedRow},
        Harmless{"pcvt site_orbits row", "delete", kNoOrbits},
        Harmless{"pcvt site_orbits 9.0", "word", kNoOrbits},
        Harmless{"$Nodes 3.0", "", "a node inside of a grain; the mesh is another one", "grains"},
        Harmless{"$Nodes 3.1", "", "a node inside of a grain; the mesh is another one", "grains"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
