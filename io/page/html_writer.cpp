#include "io/page/html_writer.hpp"

#include <array>
#include <filesystem>

#include "io/bytes/text.hpp"
#include "io/colours/site_classes.hpp"
#include "io/page/page_parts.hpp"
#include "io/page/page_text.hpp"
#include "io/tiles/finite.hpp"
#include "mesher/plane/tile/tile_valence.hpp"

namespace pcvt {
namespace {

constexpr int kVersion = 1;

/// Appends `values` as a JSON list.
template <class Values>
void append_list(std::string& text, const Values& values) {
    text += '[';
    for (const auto value : values) {
        if (text.back() != '[') text += ',';
        append_number(text, value);
    }
    text += ']';
}

void append_points(std::string& text, const std::vector<plane::Vec2>& points) {
    text += '[';
    for (const plane::Vec2& p : points) {
        if (text.back() != '[') text += ',';
        append_number(text, p.x());
        text += ',';
        append_number(text, p.y());
    }
    text += ']';
}

/// Appends a list of `n` lists, one a line.
template <class ToNumbers>
void append_rows(std::string& text, int n, ToNumbers to_numbers) {
    text += '[';
    for (int k = 0; k < n; ++k) {
        text += k == 0 ? "\n" : ",\n";
        append_list(text, to_numbers(k));
    }
    text += ']';
}

void append_key(std::string& text, const char* key) {
    text += ",\n\"";
    text += key;
    text += "\": ";
}

/// Appends the names of the phases, and the phase of each site of one period.
void append_phases(std::string& text, const CellMaterials* materials) {
    const CellMaterials none;
    const CellMaterials& shown = materials == nullptr ? none : *materials;
    append_key(text, "phases");
    text += '[';
    for (const std::string& name : shown.phase_names) {
        text += (text.back() == '[' ? "" : ", ") + json_string(name);
    }
    text += ']';
    append_key(text, "site_phases");
    append_list(text, shown.site_phase);
}

/// Appends whether the sides across x and across y are walls, and the ends of each edge on a wall
/// with the name of the wall; nothing without walls.
void append_walls(std::string& text, const plane::Tile& tile) {
    if (tile.wall_edges.empty()) return;
    append_key(text, "walls");
    append_list(text, std::array{int{has_walls_across(tile.walls, 0)},
                                 int{has_walls_across(tile.walls, 1)}});
    append_key(text, "wall_edges");
    text += '[';
    for (const plane::WallEdge& edge : tile.wall_edges) {
        text += text.back() == '[' ? "\n[" : ",\n[";
        for (const int v : {edge.v0, edge.v1}) {
            append_number(text, v);
            text += ',';
        }
        text += json_string(wall_name(tile, edge.wall)) + "]";
    }
    text += ']';
}

std::string page_data(const plane::Tile& tile, const FileOptions& options,
                      const std::string& name) {
    const bool owned = faces_have_sites(tile.kind);
    std::string text = "{\"format\": \"pcvt page\", \"version\": ";
    append_number(text, kVersion);
    append_key(text, "name");
    text += json_string(name);
    const Colouring colouring =
        options.colouring.value_or(default_picture_colouring(tile, options.quantities()));
    append_key(text, "colouring");
    text += json_string(colouring_row(colouring).word);
    append_key(text, "kind");
    text += json_string(file_word(tile.kind));
    append_key(text, "lattice");
    append_rows(text, 2, [&](int k) { return k == 0 ? tile.lattice.a() : tile.lattice.b(); });
    append_key(text, "points");
    append_points(text, tile.points);
    append_key(text, "faces");
    append_rows(text, tile.n_faces(), [&](int f) { return tile.faces[f]; });
    append_key(text, "sites");
    append_list(text, owned ? tile.face_site : tile.vertex_site);
    append_key(text, "sides");
    append_list(text, owned ? cell_sides(tile) : vertex_valences(tile));
    append_key(text, "site_points");
    append_points(text, tile.site_points);
    append_key(text, "densities");
    append_list(text, options.site_densities);
    append_phases(text, options.materials);
    append_key(text, "orbits");
    append_list(text, options.site_orbits);
    append_key(text, "orbit_classes");
    append_list(text, owned && !options.site_orbits.empty()
                          ? site_classes(tile, options.site_orbits)
                          : std::vector<int>());
    append_key(text, "classes");
    append_list(text, owned ? site_classes(tile) : std::vector<int>());
    append_key(text, "vertex_pairs");
    append_rows(text, static_cast<int>(tile.vertex_pairs.size()), [&](int k) {
        const plane::VertexPair& p = tile.vertex_pairs[static_cast<std::size_t>(k)];
        return std::array{p.v, p.w, p.offset.i, p.offset.j};
    });
    append_key(text, "edge_pairs");
    append_rows(text, static_cast<int>(tile.edge_pairs.size()), [&](int k) {
        const plane::EdgePair& p = tile.edge_pairs[static_cast<std::size_t>(k)];
        return std::array{p.v0, p.v1, p.w0, p.w1, p.offset.i, p.offset.j};
    });
    append_walls(text, tile);
    return text + "}";
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
