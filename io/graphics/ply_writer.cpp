#include "io/graphics/ply_writer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/palette.hpp"
#include "io/tiles/triangle_fan.hpp"
#include "mesher/tile/tile_valence.hpp"

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

/// The colour of each number of sides as words, computed once.
class SideColours {
   public:
    const std::string& of(int sides) {
        const auto [found, is_new] = words_.try_emplace(sides);
        if (is_new) found->second = words(side_colour(sides));
        return found->second;
    }

   private:
    std::map<int, std::string> words_;
};

void end_line(std::string& text) { text.back() = '\n'; }

std::string header(const Tile& tile, bool single_precision) {
    // Kind and lattice are comments.
    const bool owned = faces_have_sites(tile.kind);
    const Vec2& a = tile.lattice.a();
    const Vec2& b = tile.lattice.b();
    std::string text =
        "ply\nformat ascii 1.0\ncomment A periodic tile, written by pcvt\n"
        "comment position = position(orbit) + offset_i a + offset_j b, lattice ax ay bx by\n"
        "comment pcvt kind " +
        file_word(tile.kind) + "\ncomment pcvt lattice ";
    for (const double number : {a.x(), a.y(), b.x(), b.y()}) append_word(text, number);
    end_line(text);
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
    return text + "end_header\n";
}

void append_vertices(std::string& text, const Tile& tile, bool single_precision) {
    const bool owned = faces_have_sites(tile.kind);
    // Delaunay triangles have coloured vertices.
    const std::vector<int> valences = owned ? std::vector<int>() : vertex_valences(tile);
    const std::string plain = words(kPlain);
    SideColours colours;
    // A vertex without a pair is its own representative.
    std::vector<VertexPair> orbits;
    orbits.reserve(tile.points.size());
    for (int v = 0; v < tile.n_vertices(); ++v) orbits.push_back({v, v, {}});
    for (const VertexPair& pair : tile.vertex_pairs) orbits[pair.w] = pair;
    // One vertex per line.
    for (int v = 0; v < tile.n_vertices(); ++v) {
        for (const double x : tile.points[v]) {
            single_precision ? append_word(text, static_cast<float>(x)) : append_word(text, x);
        }
        append_word(text, 0);
        text += owned ? plain : colours.of(valences[v]);
        append_word(text, orbits[v].v);
        append_word(text, orbits[v].offset.i);
        append_word(text, orbits[v].offset.j);
        if (!owned) append_word(text, tile.vertex_site[v]);
        end_line(text);
    }
}

void append_faces(std::string& text, const Tile& tile, const std::vector<int>& sides) {
    const bool owned = faces_have_sites(tile.kind);
    const std::string plain = words(kPlain);
    SideColours colours;
    for (int f = 0; f < tile.n_faces(); ++f) {
        append_word(text, tile.face_size(f));
        for (const int v : tile.faces[f]) {
            append_word(text, v);
        }
        text += owned ? colours.of(sides[f]) : plain;
        if (owned) append_word(text, tile.face_site[f]);
        end_line(text);
    }
}

std::string ply_text(const Tile& tile, const std::vector<int>& sides, bool single_precision) {
    std::string text = header(tile, single_precision);
    append_vertices(text, tile, single_precision);
    append_faces(text, tile, sides);
    return text;
}

/// Returns the tile with its cells as triangles.
/// @param sides  of the cell of each face; changes with the faces.
Tile narrowed(const Tile& tile, std::vector<int>& sides, const std::string& path) {
    const std::vector<Point32> points = single_precision_points(tile, path);
    if (tile.kind != MeshKind::kVoronoi) return tile;
    Tile narrow = tile;
    narrow.faces = {};
    narrow.face_site.clear();
    const std::vector<int> sides_of_cells = std::exchange(sides, {});
    for (int f = 0; f < tile.n_faces(); ++f) {
        std::vector<int> corners;
        append_fan(tile, f, points, corners, path);
        for (std::size_t c = 0; c < corners.size(); c += 3) {
            narrow.faces.add(std::span(corners).subspan(c, 3));
            narrow.face_site.push_back(tile.face_site[f]);
            sides.push_back(sides_of_cells[f]);
        }
    }
    return narrow;
}

}  // namespace

std::vector<EncodedFile> encode_ply(const Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    require_finite(tile);
    std::vector<int> sides;
    if (faces_have_sites(tile.kind)) sides = cell_sides(tile);
    const bool single = options.single_precision;
    if (!single) return only_file(path, ply_text(tile, sides, single));
    const Tile narrow = narrowed(tile, sides, path);
    return only_file(path, ply_text(narrow, sides, single));
}

}  // namespace pcvt
