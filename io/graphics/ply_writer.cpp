#include "io/graphics/ply_writer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/colours/palette.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/site_notes.hpp"
#include "io/tiles/triangle_fan.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr Colour kPlain{1, 1, 1};
/// The largest number of corners of a list whose length is a uchar.
constexpr int kMostByUchar = 255;

template <class Number>
void append_word(std::string& text, Number number) {
    append_number(text, number);
    text += ' ';
}

std::string words(Colour colour) {
    std::string text;
    for (const double part : {colour.r, colour.g, colour.b}) {
        append_word(text, static_cast<int>(std::lround(255 * part)));
    }
    return text;
}

/// Returns the colour of each class as words.
std::vector<std::string> class_words(const TileColours& colours) {
    std::vector<std::string> result;
    for (const ColourClass& shown : colours.classes) result.push_back(words(shown.colour));
    return result;
}

void end_line(std::string& text) { text.back() = '\n'; }

/// @param notes  of the tile and of its sites.
std::string header(const plane::Tile& tile, const std::vector<StatedNote>& notes,
                   bool single_precision) {
    // Kind and lattice are comments.
    const bool owned = faces_have_sites(tile.kind);
    const plane::Vec2& a = tile.lattice.a();
    const plane::Vec2& b = tile.lattice.b();
    std::string text =
        "ply\nformat ascii 1.0\ncomment A periodic tile, written by pcvt\n"
        "comment position = position(orbit) + offset_i a + offset_j b, lattice ax ay bx by\n"
        "comment pcvt kind " +
        file_word(tile.kind) + "\ncomment pcvt lattice ";
    for (const double number : {a.x(), a.y(), b.x(), b.y()}) append_word(text, number);
    end_line(text);
    append_tile_notes(text, "comment pcvt ", notes);
    append_hole_comments(text, "comment pcvt ", tile, 0);
    // Vertices have a position, a colour and their place on their orbit.
    text += "element vertex " + std::to_string(tile.n_vertices()) +
            (single_precision ? "\nproperty float x\nproperty float y\nproperty float z\n"
                              : "\nproperty double x\nproperty double y\nproperty double z\n") +
            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "property int orbit\nproperty int offset_i\nproperty int offset_j\n";
    if (!owned) text += "property int site\n";
    // Faces are lists, with a length as narrow as the largest face permits.
    int most_corners = 0;
    for (int f = 0; f < tile.n_faces(); ++f)
        most_corners = std::max(most_corners, tile.face_size(f));
    text += "element face " + std::to_string(tile.n_faces()) + "\nproperty list ";
    text += most_corners <= kMostByUchar ? "uchar" : "int";
    text += " int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n";
    if (owned) text += "property int site\n";
    // Sites have a position, and perhaps a weight.
    const SiteRows sites = site_rows(notes);
    if (sites.n_sites() > 0) {
        text += "element site " + std::to_string(sites.n_sites()) + '\n';
        const std::vector<std::string_view> parts = site_parts();
        for (std::size_t k = 0; k < sites.width; ++k) {
            text += single_precision ? "property float " : "property double ";
            (text += parts[k]) += '\n';
        }
    }
    return text + "end_header\n";
}

void append_real(std::string& text, double x, bool single_precision) {
    single_precision ? append_word(text, static_cast<float>(x)) : append_word(text, x);
}

void append_coordinates(std::string& text, const plane::Vec2& p, bool single_precision) {
    for (const double x : p) append_real(text, x, single_precision);
}

void append_vertices(std::string& text, const plane::Tile& tile, const TileColours& colours,
                     bool single_precision) {
    const bool owned = faces_have_sites(tile.kind);
    // Delaunay triangles have coloured vertices.
    const std::string plain = words(kPlain);
    const std::vector<std::string> coloured = class_words(colours);
    // A vertex without a pair is its own representative.
    std::vector<plane::VertexPair> orbits;
    orbits.reserve(tile.points.size());
    for (int v = 0; v < tile.n_vertices(); ++v) orbits.push_back({v, v, {}});
    for (const plane::VertexPair& pair : tile.vertex_pairs) orbits[pair.w] = pair;
    // One vertex per line.
    for (int v = 0; v < tile.n_vertices(); ++v) {
        checkpoint_each(v);
        append_coordinates(text, tile.points[v], single_precision);
        append_word(text, 0);
        text += owned ? plain : coloured[colours.class_of[v]];
        append_word(text, orbits[v].v);
        append_word(text, orbits[v].offset.i);
        append_word(text, orbits[v].offset.j);
        if (!owned) append_word(text, tile.vertex_site[v]);
        end_line(text);
    }
}

void append_faces(std::string& text, const plane::Tile& tile, const TileColours& colours) {
    const bool owned = faces_have_sites(tile.kind);
    const std::string plain = words(kPlain);
    const std::vector<std::string> coloured = class_words(colours);
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        append_word(text, tile.face_size(f));
        for (const int v : tile.faces[f]) {
            append_word(text, v);
        }
        text += owned ? coloured[colours.class_of[f]] : plain;
        if (owned) append_word(text, tile.face_site[f]);
        end_line(text);
    }
}

std::string ply_text(const plane::Tile& tile, const TileColours& colours,
                     const std::vector<StatedNote>& notes, bool single_precision) {
    std::string text = header(tile, notes, single_precision);
    append_vertices(text, tile, colours, single_precision);
    append_faces(text, tile, colours);
    const SiteRows sites = site_rows(notes);
    for (std::size_t s = 0; s < sites.n_sites(); ++s) {
        for (const double number : sites[s]) append_real(text, number, single_precision);
        end_line(text);
    }
    return text;
}

/// Returns the tile with its cells as triangles.
/// @param class_of  the class of the colour of each face; changes with the faces.
plane::Tile narrowed(const plane::Tile& tile, std::vector<int>& class_of, const std::string& path) {
    const std::vector<Point32> points = single_precision_points(tile, path);
    if (tile.kind != plane::MeshKind::kVoronoi) return tile;
    plane::Tile narrow = tile;
    narrow.faces = {};
    narrow.face_site.clear();
    const std::vector<int> classes_of_cells = std::exchange(class_of, {});
    std::vector<int> corners;
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        const std::size_t begin = corners.size();
        append_fan(tile, f, f - 1, points, corners, path);
        for (std::size_t c = begin; c < corners.size(); c += 3) {
            narrow.faces.add(std::span(corners).subspan(c, 3));
            narrow.face_site.push_back(tile.face_site[f]);
            class_of.push_back(classes_of_cells[f]);
        }
    }
    return narrow;
}

}  // namespace

std::vector<EncodedFile> encode_ply(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    require_finite(tile);
    TileColours colours =
        tile_colours(tile, options.colouring.value_or(Colouring::kSides), options.quantities());
    const bool single = options.single_precision;
    const std::vector<StatedNote> notes = stated_notes(tile);
    if (!single) return only_file(path, ply_text(tile, colours, notes, single));
    const plane::Tile narrow = narrowed(tile, colours.class_of, path);
    return only_file(path, ply_text(narrow, colours, notes, single));
}

}  // namespace pcvt
