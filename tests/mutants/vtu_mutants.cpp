#include <array>

#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {
namespace {

/// Real numbers change by this much.
constexpr double kDigit = 1e-5;

/// Names the words of a VTU: those of a tag by the tag, the values of an array by the array.
class VtuNamer {
   public:
    LineNames operator()(const std::vector<std::string_view>& words) {
        if (words.empty() || words[0].starts_with('?') || words[0].starts_with('!')) return {};
        if (!is_number(words[0])) return names_of_tag(words);
        LineNames names{.row = array_ + " row"};
        for (std::size_t w = 0; w < words.size(); ++w) names.words.push_back(array_ + " value");
        return names;
    }

   private:
    static bool is_number(std::string_view word) {
        return word[0] == '-' || (word[0] >= '0' && word[0] <= '9');
    }

    /// The words of a tag are its element, and the names and the values of its attributes.
    LineNames names_of_tag(const std::vector<std::string_view>& words) {
        for (std::size_t w = 0; w + 1 < words.size(); ++w) {
            if (words[w] == "Name") array_ = std::string(words[w + 1]);
        }
        const std::string tag = words[0] == "DataArray" ? array_ : std::string(words[0]);
        LineNames names{.row = "", .words = {tag + " tag"}};
        for (std::size_t w = 1; w < words.size(); ++w) {
            const bool is_value = w % 2 == 0;
            names.words.push_back(tag + " " + std::string(words[is_value ? w - 1 : w]) +
                                  (is_value ? "" : " key"));
        }
        return names;
    }

    std::string array_;
};

}  // namespace

std::vector<Mutant> vtu_mutants(const BaseFile& base) {
    return text_mutants(base.files, 0, VtuNamer(), "<>\"=/", kDigit);
}

std::span<const Harmless> harmless_in_vtu() {
    static constexpr std::array kHarmless{
        Harmless{"SiteWeights*", "", kNotShown, "delaunay"},
        Harmless{"SiteWeights*", "", kNotShown, "grains"},
        Harmless{"Metric*", "", kNotShown, "delaunay"},
        Harmless{"Metric*", "", kNotShown, "grains"},
        Harmless{"VTKFile *", "", "the versions of the format do not differ in what it uses"},
        Harmless{"ShortEdges value", "",
                 "a longer bound of the removed edges, which the proof alone reads"},
        Harmless{"Points Name*", "", "VTK finds the points by their element"},
        Harmless{"Points value", "", "a node inside of a grain; the mesh is another one", "grains"},
        Harmless{"connectivity row", "swap", "the order of the elements of one cell"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
