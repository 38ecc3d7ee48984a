#include <array>
#include <map>

#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {
namespace {

/// Names the words of a PLY: first those of the header, which declares the rows of each element.
class PlyNamer {
   public:
    LineNames operator()(const std::vector<std::string_view>& words) {
        if (words.empty()) return {};
        return in_header_ ? header_names(words) : row_names(words);
    }

   private:
    struct Element {
        std::string name;
        int n_rows;
        std::vector<std::string> properties;
    };

    LineNames header_names(const std::vector<std::string_view>& words) {
        if (words[0] == "end_header") {
            in_header_ = false;
            return {};
        }
        if (words[0] == "element") {
            elements_.push_back({std::string(words[1]), std::stoi(std::string(words[2])), {}});
            return {"element row", {"", "element.name", "element.count"}};
        }
        if (words[0] == "property") {
            const bool is_list = words[1] == "list";
            const std::string name(words.back());
            elements_.back().properties.push_back(elements_.back().name + "." +
                                                  (is_list ? "list" : name));
            LineNames names{"property row",
                            std::vector<std::string>(words.size(), "property.type")};
            names.words[0] = "";
            if (is_list) names.words[1] = "";
            names.words.back() = "property.name";
            return names;
        }
        if (words[0] != "comment" || words.size() < 3 || words[1] != "pcvt") return {};
        LineNames names{std::string(words[2]) + " row",
                        std::vector<std::string>(words.size(), std::string(words[2]))};
        for (std::size_t w = 0; w < 3; ++w) names.words[w] = "";
        return names;
    }

    LineNames row_names(const std::vector<std::string_view>& words) {
        while (at_ < elements_.size() && row_ == elements_[at_].n_rows) {
            ++at_;
            row_ = 0;
        }
        if (at_ == elements_.size()) return {};
        ++row_;
        const Element& element = elements_[at_];
        LineNames names{element.name + " row"};
        for (const std::string& property : element.properties) {
            std::size_t n = 1;
            if (property.ends_with(".list"))
                n += std::stoul(std::string(words[names.words.size()]));
            names.words.resize(names.words.size() + n, property);
        }
        return names;
    }

    bool in_header_ = true;
    std::vector<Element> elements_;
    std::size_t at_ = 0;
    int row_ = 0;
};

}  // namespace

std::vector<Mutant> ply_mutants(const BaseFile& base) {
    const TextParts parts = text_parts(base.files, 0, PlyNamer());
    std::vector<Mutant> mutants = mutants_of(parts.fields, kDigit);
    mutants.insert(mutants.end(), parts.rows.begin(), parts.rows.end());
    return mutants;
}

std::span<const Harmless> harmless_in_ply() {
    static constexpr std::array kHarmless{
        Harmless{"vertex.x", "digit", kStretched, "voronoi power float32"},
        Harmless{"vertex.y", "digit", kStretched, "voronoi power float32"},
        Harmless{"vertex.x", "digit", kStretched, "voronoi power box float32"},
        Harmless{"vertex.y", "digit", kStretched, "voronoi power box float32"},
        Harmless{"vertex.x", "digit", kStretched, "voronoi power 2x1 float32"},
        Harmless{"vertex.y", "digit", kStretched, "voronoi power 2x1 float32"},
        Harmless{"site*", "digit", kStretched, "voronoi power float32"},
        Harmless{"metric", "digit", kStretched, "voronoi power float32"},
        Harmless{"site*", "digit", kStretched, "voronoi power box float32"},
        Harmless{"metric", "digit", kStretched, "voronoi power box float32"},
        Harmless{"site*", "digit", kStretched, "voronoi power 2x1 float32"},
        Harmless{"metric", "digit", kStretched, "voronoi power 2x1 float32"},
        Harmless{"site*", "digit", kStretched, "delaunay power float32"},
        Harmless{"vertex*", "digit", kStretched, "delaunay power float32"},
        Harmless{"site*", "digit", kStretched, "grains power float32"},
        Harmless{"site.weight", "", kNotShown, "delaunay"},
        Harmless{"site.weight", "", kNotShown, "grains"},
        Harmless{"metric*", "", kNotShown, "delaunay"},
        Harmless{"metric*", "", kNotShown, "grains"},
        Harmless{"vertex.x", "digit", kSingle, "voronoi short-edges float32"},
        Harmless{"vertex.y", "digit", kSingle, "voronoi short-edges float32"},
        Harmless{"site.x", "digit", kSingle, "voronoi short-edges float32"},
        Harmless{"site.y", "digit", kSingle, "voronoi short-edges float32"},
        Harmless{"site.x", "digit", kSingle, "grains whole float32"},
        Harmless{"site.y", "digit", kSingle, "grains whole float32"},
        Harmless{"site.x", "digit", kSingle, "grains box float32"},
        Harmless{"site.y", "digit", kSingle, "grains box float32"},
        Harmless{"vertex.red", "", "colours have no meaning for the tile"},
        Harmless{"vertex.green", "", "colours have no meaning for the tile"},
        Harmless{"vertex.blue", "", "colours have no meaning for the tile"},
        Harmless{"face.red", "", "colours have no meaning for the tile"},
        Harmless{"face.green", "", "colours have no meaning for the tile"},
        Harmless{"face.blue", "", "colours have no meaning for the tile"},
        Harmless{"property.type", "exchange", "a wider type of the length of a list"},
        Harmless{"short_edges*", "", "lets corners that were joined lie farther off"},
        Harmless{"face row", "swap", "the order of faces, each with its site"},
        Harmless{"vertex.x", "", "a vertex inside of a grain; the mesh is another one", "grains"},
        Harmless{"vertex.y", "", "a vertex inside of a grain; the mesh is another one", "grains"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
