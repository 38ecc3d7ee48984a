#include "io/graphics/obj_writer.hpp"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <numeric>
#include <set>

#include "io/bytes/extension.hpp"
#include "io/bytes/text.hpp"
#include "io/graphics/seam_json.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/site_notes.hpp"
#include "io/tiles/site_orbits.hpp"
#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/tile/texture_coordinates.hpp"

namespace pcvt {
namespace {

/// The longest texts of numbers, with a blank before them: -2147483648 and
/// -2.2250738585072014e-308.
constexpr std::size_t kLongestInteger = 12;
constexpr std::size_t kLongestNumber = 25;
constexpr Colour kTriangleColour{0.8, 0.8, 0.8};

constexpr const char* kExplanation =
    "# A periodic tile, written by pcvt. Comments that begin with \"# pcvt\" hold its seam:\n"
    "#   kind cells|triangles|grains\n"
    "#   lattice ax ay bx by        the period vectors a and b\n"
    "#   vertex_pair v w i j        vertex w lies at vertex v + i a + j b\n"
    "#   edge_pair v0 v1 w0 w1 i j  boundary edge v0 v1 + i a + j b is boundary edge w0 w1\n"
    "#   sites s ...                the site of each face (or vertex of triangles), in order\n";
constexpr const char* kOrbitExplanation =
    "#   site_orbits k ...          the orbit of site 0, 1, ... under the symmetry\n";

template <class Number>
void append_words(std::string& text, std::initializer_list<Number> numbers) {
    for (const Number number : numbers) {
        text += ' ';
        append_number(text, number);
    }
    text += '\n';
}

/// Returns the colours of the faces, which are materials. Triangles have one.
TileColours material_colours(const plane::Tile& tile, const FileOptions& options) {
    if (faces_have_sites(tile.kind)) {
        const Colouring colouring = options.colouring.value_or(Colouring::kSides);
        return tile_colours(tile, colouring, options.quantities());
    }
    TileColours grey;
    grey.classes.push_back({kTriangleColour, "triangle", ""});
    grey.class_of.assign(static_cast<std::size_t>(tile.n_faces()), 0);
    return grey;
}

/// Returns the tile with its faces in the order `order`.
plane::Tile with_faces_in_order(const plane::Tile& tile, const std::vector<int>& order) {
    plane::Tile sorted = tile;
    sorted.faces = {};
    sorted.face_site.clear();
    sorted.faces.begin.reserve(tile.faces.begin.size());
    sorted.faces.corners.reserve(tile.faces.corners.size());
    sorted.face_site.reserve(tile.face_site.size());
    for (const int f : order) {
        sorted.faces.add(tile.faces[f]);
        if (!tile.face_site.empty()) sorted.face_site.push_back(tile.face_site[f]);
    }
    for (std::vector<plane::Vec2> plane::Tile::*const points :
         {&plane::Tile::site_points, &plane::Tile::grain_site_points}) {
        if ((tile.*points).size() != order.size()) continue;
        for (std::size_t k = 0; k < order.size(); ++k)
            (sorted.*points)[k] = (tile.*points)[order[k]];
    }
    return sorted;
}

void append_seam(std::string& text, const plane::Tile& tile) {
    // Kind and lattice.
    const plane::Vec2& a = tile.lattice.a();
    const plane::Vec2& b = tile.lattice.b();
    text += "# pcvt kind " + file_word(tile.kind) + "\n# pcvt lattice";
    append_words(text, {a.x(), a.y(), b.x(), b.y()});
    // Pairs, with vertices counted from 1.
    for (const plane::VertexPair& p : tile.vertex_pairs) {
        text += "# pcvt vertex_pair";
        append_words(text, {p.v + 1, p.w + 1, p.offset.i, p.offset.j});
    }
    for (const plane::EdgePair& p : tile.edge_pairs) {
        text += "# pcvt edge_pair";
        append_words(text, {p.v0 + 1, p.v1 + 1, p.w0 + 1, p.w1 + 1, p.offset.i, p.offset.j});
    }
    // Sites, several per line.
    const auto& sites = faces_have_sites(tile.kind) ? tile.face_site : tile.vertex_site;
    for (std::size_t k = 0; k < sites.size(); ++k) {
        if (k % kSitesALine == 0) text += k == 0 ? "# pcvt sites" : "\n# pcvt sites";
        text += ' ';
        append_number(text, sites[k]);
    }
    text += '\n';
    append_note_comments(text, "# pcvt ", tile, 1);
}

std::string obj_text(const plane::Tile& tile, const TileColours& colours,
                     const std::string& material_file, std::span<const int> site_orbits) {
    const std::vector<int>& material = colours.class_of;
    // Memory that is reserved and not used costs nothing, in contrast to a text that is moved.
    std::string text;
    text.reserve((5 * tile.points.size() + 2 * tile.site_points.size() + tile.site_weights.size()) *
                     kLongestNumber +
                 (2 * tile.faces.corners.size() + tile.faces.begin.size()) * kLongestInteger);
    text += kExplanation;
    append_note_meanings(text, "#   ");
    if (!site_orbits.empty()) text += kOrbitExplanation;
    text += "# Vertices count from 1, sites from 0.\n";
    append_seam(text, tile);
    append_site_orbits(text, "# pcvt ", site_orbits);
    text += "mtllib " + material_file + "\n";
    for (const plane::Vec2& p : tile.points) {
        text += 'v';
        append_words(text, {p.x(), p.y(), 0.0});
    }
    for (const auto& [u, v] : texture_coordinates(tile)) {
        text += "vt";
        append_words(text, {double(u), double(v)});
    }
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        if (f == 0 || material[f] != material[f - 1]) {
            text += "usemtl " + colours.classes[material[f]].name + "\n";
        }
        text += 'f';
        for (const int v : tile.faces[f]) {
            text += ' ';
            append_number(text, v + 1);
            text += '/';
            append_number(text, v + 1);
        }
        text += '\n';
    }
    return text;
}

std::string mtl_text(const TileColours& colours) {
    std::string text = "# Materials of a periodic tile, written by pcvt\n";
    for (const int k : std::set<int>(colours.class_of.begin(), colours.class_of.end())) {
        const ColourClass& material = colours.classes[k];
        text += "newmtl " + material.name + "\nKd";
        append_words(text, {material.colour.r, material.colour.g, material.colour.b});
    }
    return text;
}

}  // namespace

std::vector<std::string> obj_paths(const std::string& path) {
    return {path, one_word_beside(path, ".mtl"),
            std::filesystem::path(path).replace_extension(".seam.json").string()};
}

std::vector<EncodedFile> encode_obj(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    require_finite(tile);
    TileColours colours = material_colours(tile, options);
    std::vector<int>& material = colours.class_of;
    std::vector<int> order(material.size());
    std::iota(order.begin(), order.end(), 0);
    cancellable_stable_sort(order.begin(), order.end(),
                            [&](int f, int g) { return material[f] < material[g]; });
    const plane::Tile sorted = with_faces_in_order(tile, order);
    std::sort(material.begin(), material.end());
    const std::vector<std::string> paths = obj_paths(path);
    const std::string material_file = std::filesystem::path(paths[1]).filename().string();
    std::vector<EncodedFile> files =
        only_file(paths[0], obj_text(sorted, colours, material_file, options.site_orbits));
    files.push_back({paths[1], mtl_text(colours)});
    files.push_back({paths[2], encode_seam(sorted)});
    return files;
}

}  // namespace pcvt
