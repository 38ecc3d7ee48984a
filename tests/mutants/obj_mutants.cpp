#include <array>

#include "tests/mutants/mutated_formats.hpp"

namespace pcvt::testing {
namespace {

/// `name` repeated with a number behind it.
LineNames numbered(const std::string& row, std::size_t n_skipped, std::size_t n_words,
                   const std::string& name) {
    LineNames names{.row = row};
    names.words.assign(n_skipped, "");
    names.words.resize(n_words, name);
    return names;
}

LineNames names_of_obj(const std::vector<std::string_view>& words) {
    if (words.empty()) return {};
    if (words[0] == "v") return {"v row", {"", "v.x", "v.y", "v.z"}};
    if (words[0] == "vt") return {"vt row", {"", "vt.u", "vt.v"}};
    if (words[0] == "f") return numbered("f row", 1, words.size(), "f.index");
    if (words[0] == "usemtl") return {"usemtl row", {"", "usemtl.name"}};
    if (words[0] == "mtllib") return {"mtllib row", {"", "mtllib.name"}};
    if (words.size() < 3 || words[0] != "#" || words[1] != "pcvt") return {};
    const std::string key(words[2]);
    LineNames names = numbered(key + " row", 3, words.size(), key);
    if (key == "sites") names.n_before_part = 3;
    if (key == "site" && words.size() == 6) names.words.back() = "site.weight";
    return names;
}

LineNames names_of_mtl(const std::vector<std::string_view>& words) {
    if (words.empty()) return {};
    if (words[0] == "newmtl") return {"newmtl row", {"", "newmtl.name"}};
    if (words[0] == "Kd") return {"Kd row", {"", "Kd.colour", "Kd.colour", "Kd.colour"}};
    return {};
}

}  // namespace

std::vector<Mutant> obj_mutants(const BaseFile& base) {
    std::vector<Mutant> mutants;
    const auto add = [&](std::size_t file, const LineNamer& namer, std::string_view separators) {
        const TextParts parts = text_parts(base.files, file, namer, separators);
        for (const std::vector<Mutant>& more : {mutants_of(parts.fields, kDigit), parts.rows}) {
            mutants.insert(mutants.end(), more.begin(), more.end());
        }
    };
    add(0, names_of_obj, "/");
    // The proof of only the file, without the sidecar, which repeats the labels.
    const std::size_t n_beside = mutants.size();
    for (std::size_t k = 0; k < n_beside; ++k) {
        mutants.push_back({"alone " + mutants[k].field, mutants[k].change,
                           [files = mutants[k].files] { return Files{files().front()}; }});
    }
    add(1, names_of_mtl, "");
    // Surfaces in space have no sidecar.
    if (base.files.size() < 3) return mutants;
    std::string key;
    add(
        2,
        [&key](const std::vector<std::string_view>& words) {
            LineNames names;
            for (const std::string_view word : words) {
                const bool is_key = word.size() > 2 && word[0] == '"';
                if (is_key) key = "json " + std::string(word.substr(1, word.size() - 2));
                names.words.push_back(is_key ? "" : key);
            }
            return names;
        },
        ",:[]{}");
    return mutants;
}

std::span<const Harmless> harmless_in_obj() {
    static constexpr std::array kHarmless{
        Harmless{"site.weight", "", kNotShown, "delaunay"},
        Harmless{"site.weight", "", kNotShown, "grains"},
        Harmless{"alone site.weight", "", kNotShown, "delaunay"},
        Harmless{"alone site.weight", "", kNotShown, "grains"},
        Harmless{"metric*", "", kNotShown, "delaunay"},
        Harmless{"metric*", "", kNotShown, "grains"},
        Harmless{"alone metric*", "", kNotShown, "delaunay"},
        Harmless{"alone metric*", "", kNotShown, "grains"},
        Harmless{"site_orbits", "", kStatedOrbits, "delaunay"},
        Harmless{"site_orbits", "", kStatedOrbits, "grains"},
        Harmless{"alone site_orbits", "", kStatedOrbits, "delaunay"},
        Harmless{"alone site_orbits", "", kStatedOrbits, "grains"},
        Harmless{"site_orbits", "+1", kOwnOrbit, "voronoi symmetric"},
        Harmless{"alone site_orbits", "+1", kOwnOrbit, "voronoi symmetric"},
        Harmless{"v.y", "sign", "a coordinate below the rounding", "grains symmetric"},
        Harmless{"alone v.y", "sign", "a coordinate below the rounding", "grains symmetric"},
        Harmless{"site_orbits row", "delete", kNoOrbits},
        Harmless{"alone site_orbits row", "delete", kNoOrbits},
        Harmless{"Kd.colour", "", "colours have no meaning for the tile"},
        Harmless{"f row", "swap", "the order of triangles, or of two pieces of one cell"},
        Harmless{"alone f row", "swap", "the order of triangles, or of two pieces of one cell"},
        Harmless{"short_edges*", "", "lets corners that were joined lie farther off"},
        Harmless{"alone short_edges*", "", "lets corners that were joined lie farther off"},
        Harmless{"alone mtllib*", "", "the material file is missing"},
        Harmless{"alone usemtl*", "", "the material file is missing"},
        Harmless{"alone vertex_pair row", "swap", "the order of pairs"},
        Harmless{"alone edge_pair row", "swap", "the order of pairs"},
        Harmless{"alone vertex_pair row", "duplicate", "says the same twice"},
        Harmless{"alone edge_pair row", "duplicate", "says the same twice"},
    };
    return kHarmless;
}

}  // namespace pcvt::testing
