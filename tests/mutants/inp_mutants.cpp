#include <array>

#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {
namespace {

/// Names the words of an Abaqus input by their card and their place in the row.
class InpNamer {
   public:
    LineNames operator()(const std::vector<std::string_view>& words) {
        if (words.empty()) return {};
        if (words[0] == "**") return names_of_comment(words);
        LineNames names;
        if (words[0].starts_with('*')) {
            card_ = std::string(words[0]);
            if (words.back().starts_with("CONTROL_")) card_ += " control";
            names.words.assign(words.size(), "card " + card_);
            return names;
        }
        const bool is_set = card_.ends_with("SET");
        for (std::size_t w = 0; w < words.size(); ++w) {
            names.words.push_back(card_ + (is_set ? " member" : "." + std::to_string(w)));
        }
        names.row = card_ + " row";
        return names;
    }

   private:
    static LineNames names_of_comment(const std::vector<std::string_view>& words) {
        if (words.size() < 3 || words[1] != "pcvt") return {};
        LineNames names{.row = "pcvt " + std::string(words[2]) + " row", .words = {"", "", "pcvt"}};
        names.words.resize(words.size(), "pcvt " + std::string(words[2]));
        if (words[2] == "site" && words.size() == 6) names.words.back() = "pcvt weight";
        return names;
    }

    std::string card_;
};

}  // namespace

std::vector<Mutant> inp_mutants(const BaseFile& base) {
    return text_mutants(base.files, 0, InpNamer(), ",=", kDigit);
}

std::span<const Harmless> harmless_in_inp() {
    static constexpr std::array kHarmless{
        Harmless{"pcvt weight", "", kNotShown, "delaunay"},
        Harmless{"pcvt weight", "", kNotShown, "grains"},
        Harmless{"pcvt metric*", "", kNotShown, "delaunay"},
        Harmless{"pcvt metric*", "", kNotShown, "grains"},
        Harmless{"pcvt site_orbits row", "delete", kNoOrbits},
        Harmless{"*NODE.1", "", "a node inside of a grain; the mesh is another one", "grains"},
        Harmless{"*NODE.2", "", "a node inside of a grain; the mesh is another one", "grains"},
        Harmless{"*NSET row", "swap", "a set has no order"},
        Harmless{"*NSET row", "duplicate", "a set has no repetitions"},
        Harmless{"*ELSET row", "swap", "a set has no order"},
        Harmless{"*ELSET row", "duplicate", "a set has no repetitions"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
