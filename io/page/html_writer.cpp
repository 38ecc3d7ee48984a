#include "io/page/html_writer.hpp"

#include <array>
#include <filesystem>

#include "io/bytes/json_writer.hpp"
#include "io/colours/cell_colours.hpp"
#include "io/colours/site_classes.hpp"
#include "io/forms/finite.hpp"
#include "io/page/page_parts.hpp"
#include "io/page/page_text.hpp"
#include "mesher/plane/tile/tile_valence.hpp"

namespace pcvt {
namespace {

constexpr int kVersion = 1;

/// One entry a line, and one member a line.
constexpr JsonLayout kRows{.before_first = "\n", .between = ",\n"};
constexpr JsonLayout kMembers{.between = ",\n"};

/// Appends the coordinates of points as one list: x0, y0, x1, ...
void append_points(JsonWriter& json, const char* key, const std::vector<plane::Vec2>& points) {
    json.key(key);
    json.begin_list();
    for (const plane::Vec2& p : points) {
        for (const double x : p) json.value(x);
    }
    json.end();
}

/// Appends a list of `n` lists, one a line.
template <class ToNumbers>
void append_rows(JsonWriter& json, const char* key, int n, ToNumbers to_numbers) {
    json.key(key);
    json.begin_list(kRows);
    for (int k = 0; k < n; ++k) json.value(to_numbers(k));
    json.end();
}

/// Appends the names of the phases, and the phase of each site of one period.
void append_phases(JsonWriter& json, const CellMaterials* materials) {
    const CellMaterials none;
    const CellMaterials& shown = materials == nullptr ? none : *materials;
    json.key("phases");
    json.values(shown.phase_names, kSpacedJson);
    json.member("site_phases", shown.site_phase);
}

/// Appends the colour of the orientation of each site of one period.
void append_pole_colours(JsonWriter& json, const CellMaterials* materials) {
    std::vector<std::string> of_site;
    if (materials != nullptr) {
        const TileColours colours = orientation_classes(materials->site_orientation);
        for (const int k : colours.class_of) of_site.push_back(hex(colours.classes[k].colour));
    }
    json.key("pole_colours");
    json.values(of_site, kSpacedJson);
}

/// Appends whether the sides across x and across y are walls, and the ends of each edge on a wall
/// with the name of the wall; nothing without walls.
void append_walls(JsonWriter& json, const plane::Tile& tile) {
    if (tile.wall_edges.empty()) return;
    json.member("walls", std::array{int{has_walls_across(tile.walls, 0)},
                                    int{has_walls_across(tile.walls, 1)}});
    json.key("wall_edges");
    json.begin_list(kRows);
    for (const plane::WallEdge& edge : tile.wall_edges) {
        json.begin_list();
        json.value(edge.v0);
        json.value(edge.v1);
        json.value(wall_name(tile, edge.wall));
        json.end();
    }
    json.end();
}

std::string page_data(const plane::Tile& tile, const FileOptions& options,
                      const std::string& name) {
    const bool owned = faces_have_sites(tile.kind);
    std::string text;
    JsonWriter json(text, kCompactJson, JsonEscapes::kInPage);
    json.begin_object(kSpacedJson);
    json.member("format", "pcvt page");
    json.member("version", kVersion);
    json.set_layout(kMembers);
    json.member("name", name);
    const Colouring colouring =
        options.colouring.value_or(default_picture_colouring(tile, options.quantities()));
    json.member("colouring", colouring_row(colouring).word);
    json.member("kind", file_word(tile.kind));
    append_rows(json, "lattice", 2,
                [&](int k) { return k == 0 ? tile.lattice.a() : tile.lattice.b(); });
    append_points(json, "points", tile.points);
    append_rows(json, "faces", tile.n_faces(), [&](int f) { return tile.faces[f]; });
    json.member("sites", owned ? tile.face_site : tile.vertex_site);
    json.member("sides", owned ? cell_sides(tile) : vertex_valences(tile));
    append_points(json, "site_points", tile.site_points);
    json.member("densities", options.site_densities);
    append_phases(json, options.materials);
    append_pole_colours(json, options.materials);
    json.member("orbits", options.site_orbits);
    json.member("orbit_classes", owned && !options.site_orbits.empty()
                                     ? site_classes(tile, options.site_orbits)
                                     : std::vector<int>());
    json.member("classes", owned ? site_classes(tile) : std::vector<int>());
    append_rows(json, "vertex_pairs", static_cast<int>(tile.vertex_pairs.size()), [&](int k) {
        const plane::VertexPair& p = tile.vertex_pairs[static_cast<std::size_t>(k)];
        return std::array{p.v, p.w, p.offset.i, p.offset.j};
    });
    append_rows(json, "edge_pairs", static_cast<int>(tile.edge_pairs.size()), [&](int k) {
        const plane::EdgePair& p = tile.edge_pairs[static_cast<std::size_t>(k)];
        return std::array{p.v0, p.v1, p.w0, p.w1, p.offset.i, p.offset.j};
    });
    append_walls(json, tile);
    json.end();
    return text;
}

}  // namespace

std::vector<EncodedFile> encode_html(const plane::Tile& tile, const FileOptions& options,
                                     const std::string& path) {
    require_finite(tile);
    const std::string name = std::filesystem::path(path).filename().string();
    return only_file(path, filled_page(kPageHtml, {{"@TITLE@", html_text(name)},
                                                   {"@STYLE@", std::string(kPageStyle)},
                                                   {"@DATA@", page_data(tile, options, name)},
                                                   {"@SCRIPT@", std::string(kPageScript)}}));
}

}  // namespace pcvt
