#include <algorithm>
#include <array>
#include <filesystem>

#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {
namespace {

/// Names the words of a file of a case by the file, and those of a dictionary by their key as well.
class FoamNamer {
   public:
    explicit FoamNamer(std::string file) : file_(std::move(file)) {}

    LineNames operator()(const std::vector<std::string_view>& words) const {
        if (words.empty()) return {};
        if (words[0].starts_with("//")) return names_of_comment(words);
        const char first = words[0][0];
        const bool is_data = first == '-' || first == '.' || (first >= '0' && first <= '9');
        const std::string name = file_ + (is_data ? " data" : " " + std::string(words[0]));
        LineNames names{.row = name + " row", .words = {is_data ? name : name + " key"}};
        names.words.resize(words.size(), name);
        return names;
    }

   private:
    static LineNames names_of_comment(const std::vector<std::string_view>& words) {
        // The line "pcvt check compares ..." is for people.
        if (words.size() < 3 || words[1] != "pcvt" || words[2] == "check") return {};
        const std::string name = "pcvt " + std::string(words[2]);
        LineNames names{.row = name + " row", .words = {"", "pcvt", "pcvt"}};
        names.words.resize(words.size(), name);
        if (words[2] == "site" && words.size() == 6) names.words.back() = "pcvt weight";
        return names;
    }

    std::string file_;
};

}  // namespace

std::vector<Mutant> foam_mutants(const BaseFile& base) {
    std::vector<Mutant> mutants;
    for (std::size_t file = 0; file < base.files.size(); ++file) {
        const std::string name = std::filesystem::path(base.files[file].path).filename().string();
        const std::vector<Mutant> more =
            text_mutants(base.files, file, FoamNamer(name), "(){};\"", kDigit);
        mutants.insert(mutants.end(), more.begin(), more.end());
    }
    return mutants;
}

std::span<const Harmless> harmless_in_foam() {
    static constexpr std::array kHarmless{
        Harmless{"pcvt", "", kNotShown, "delaunay power"},
        Harmless{"pcvt", "", "lets corners that were joined lie farther off",
                 "voronoi short-edges"},
        Harmless{"pcvt short_edges*", "", "lets corners that were joined lie farther off",
                 "voronoi short-edges"},
        Harmless{"pcvt weight", "", kNotShown, "delaunay"},
        Harmless{"pcvt weight", "", kNotShown, "grains"},
        Harmless{"pcvt metric*", "", kNotShown, "delaunay"},
        Harmless{"pcvt metric*", "", kNotShown, "grains"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
