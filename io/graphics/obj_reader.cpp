#include "io/graphics/obj_reader.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/file_tile_builder.hpp"
#include "io/forms/material_words.hpp"
#include "io/graphics/obj_appearance.hpp"
#include "io/graphics/seam_json.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr std::array<std::string_view, 4> kPassedOver{"vn", "vp", "o", "s"};

/// The statements of an OBJ.
struct ObjContent {
    std::vector<Eigen::Vector3d> points = {};
    /// The line of the first point that does not lie in the plane z = 0; 0 if there is none.
    int raised_line = 0;
    /// An index out of range stays as it is, negative or too large.
    Faces faces = {};
    std::vector<int> face_lines = {};
    ObjAppearance appearance = {};
};

/// Reads one OBJ line by line.
class ObjParser {
   public:
    /// @param take_comment  takes the words behind "# pcvt".
    ObjParser(const EncodedFile& obj, NoteTaker take_comment)
        : scanner_(obj.path, obj.bytes), take_comment_(std::move(take_comment)) {
        refuse_binary(obj.path, obj.bytes, "give a Wavefront OBJ");
    }

    ObjContent parse() {
        while (scanner_.next()) {
            checkpoint_each(scanner_.line());
            parse_line();
        }
        return std::move(obj_);
    }

   private:
    using Words = std::span<const std::string_view>;

    void parse_line() {
        // Comments of pcvt hold notes; the rest of a line after # is skipped.
        Words words = scanner_.words();
        if (words.size() >= 2 && words[0] == "#" && words[1] == "pcvt") {
            parse_comment(words.subspan(2));
            return;
        }
        const auto comment = std::find_if(words.begin(), words.end(),
                                          [](std::string_view word) { return word[0] == '#'; });
        words = words.first(static_cast<std::size_t>(comment - words.begin()));
        if (words.empty()) return;
        // Only vertices and faces matter.
        const std::string_view statement = words.front();
        words = words.subspan(1);
        if (statement == "v") {
            parse_vertex(words);
        } else if (statement == "f") {
            parse_face(words);
        } else if (statement == "vt") {
            parse_texture(words);
        } else if (statement == "usemtl") {
            obj_.appearance.materials.push_back({word_of(words), obj_.faces.n_faces()});
        } else if (statement == "mtllib") {
            obj_.appearance.libraries.emplace_back(word_of(words));
        } else if (statement == "g") {
            obj_.appearance.groups.push_back(obj_.faces.n_faces());
        } else if (std::find(kPassedOver.begin(), kPassedOver.end(), statement) ==
                   kPassedOver.end()) {
            scanner_.throw_bad_file(in_quotes(statement) +
                                    " is not a supported statement; remove the line");
        }
    }

    void parse_vertex(Words words) {
        if (words.size() != 3 && words.size() != 6) {
            scanner_.throw_bad_file(
                "a vertex has 3 numbers, or 6 with its colour; write \"v x y z\", with z = 0 in "
                "the plane");
        }
        std::array<double, 6> numbers{};
        for (std::size_t k = 0; k < words.size(); ++k) numbers[k] = scanner_.number(words[k]);
        if (numbers[2] != 0 && obj_.raised_line == 0) obj_.raised_line = scanner_.line();
        obj_.points.emplace_back(numbers[0], numbers[1], numbers[2]);
    }

    /// Returns the only word of a statement; empty if there are more.
    static std::string_view word_of(Words words) { return words.size() == 1 ? words[0] : ""; }

    void parse_texture(Words words) {
        plane::TextureCoordinate& coordinate = obj_.appearance.coordinates.emplace_back();
        for (std::size_t k = 0; k < std::min(words.size(), coordinate.size()); ++k) {
            coordinate[k] = static_cast<float>(scanner_.number(words[k]));
        }
    }

    void parse_face(Words words) {
        for (const std::string_view word : words) {
            obj_.faces.corners.push_back(parse_corner(word));
        }
        obj_.faces.close();
        obj_.face_lines.push_back(scanner_.line());
    }

    /// Returns the vertex counted from 0.
    int parse_corner(std::string_view word) {
        std::string_view rest = word;
        std::array<int, 3> indices{};
        bool has_coordinate = false;
        for (std::size_t k = 0; k < indices.size(); ++k) {
            const std::size_t length = std::min(rest.find('/'), rest.size());
            const std::string_view part = rest.substr(0, length);
            if (k != 1 || !part.empty()) indices[k] = scanner_.integer(part);
            has_coordinate = has_coordinate || (k == 1 && !part.empty());
            if (length == rest.size()) {
                if (indices[0] == 0)
                    scanner_.throw_bad_file("vertex 0 does not exist; count from 1");
                if (has_coordinate) note_texture(indices[0], indices[1]);
                const int n_vertices = static_cast<int>(obj_.points.size());
                return indices[0] > 0 ? indices[0] - 1 : n_vertices + indices[0];
            }
            rest.remove_prefix(length + 1);
        }
        scanner_.throw_bad_file(in_quotes(word) +
                                " is not a corner; write v, v/vt, v//vn or v/vt/vn");
    }

    void note_texture(int vertex, int coordinate) {
        obj_.appearance.has_corners = true;
        if (vertex != coordinate && obj_.appearance.other_index_line == 0) {
            obj_.appearance.other_index_line = scanner_.line();
        }
    }

    /// Reads the words of a comment after "# pcvt".
    void parse_comment(Words words) {
        if (words.empty())
            scanner_.throw_bad_file("a word is missing after \"# pcvt\"; remove the line");
        if (take_comment_(scanner_, words.front(), words.subspan(1))) return;
        scanner_.throw_bad_file("pcvt does not know " + in_quotes(words.front()) +
                                "; remove the line");
    }

    LineScanner scanner_;
    NoteTaker take_comment_;
    ObjContent obj_;
};

/// The notes of the pairs of a tile, which its other notes do not hold.
std::array<NoteTable, 2> pair_notes() {
    return {NoteTable{.word = "vertex_pair", .width = 4, .n_indices = 2},
            NoteTable{.word = "edge_pair", .width = 6, .n_indices = 4}};
}

void give_pairs(const std::array<NoteTable, 2>& pairs, FileTileBuilder& file) {
    const std::vector<int>& v = pairs[0].integers();
    for (std::size_t k = 0; k < v.size(); k += pairs[0].width) {
        file.vertex_pairs.push_back({v[k], v[k + 1], {v[k + 2], v[k + 3]}});
    }
    const std::vector<int>& e = pairs[1].integers();
    for (std::size_t k = 0; k < e.size(); k += pairs[1].width) {
        file.edge_pairs.push_back({.v0 = e[k],
                                   .v1 = e[k + 1],
                                   .w0 = e[k + 2],
                                   .w1 = e[k + 3],
                                   .offset = {e[k + 4], e[k + 5]}});
    }
}

/// Gives a tile the points and faces of an OBJ.
void give_polygons(ObjContent& obj, FileTileBuilder& file) {
    if (obj.raised_line > 0) {
        throw BadFile(file.name + ":" + std::to_string(obj.raised_line) +
                      ": z is not 0; move the tile to the plane z = 0");
    }
    file.points.reserve(obj.points.size());
    for (const Eigen::Vector3d& p : obj.points) file.points.emplace_back(p.x(), p.y());
    obj.points = {};
    file.faces = std::move(obj.faces);
    file.face_lines = std::move(obj.face_lines);
}

bool has_seam(const FileTileBuilder& file) {
    return file.kind || file.lattice || !file.sites.empty() || !file.vertex_pairs.empty() ||
           !file.edge_pairs.empty();
}

void take_seam(FileTileBuilder& file, Seam seam) {
    file.kind = seam.kind;
    file.lattice = seam.lattice;
    file.vertex_pairs = std::move(seam.vertex_pairs);
    file.edge_pairs = std::move(seam.edge_pairs);
    file.sites = std::move(seam.sites);
}

void compare_seam(const FileTileBuilder& file, const Seam& seam, const std::string& sidecar) {
    const auto require = [&](bool equal, const char* what) {
        if (equal) return;
        throw BadFile(sidecar + ": its " + what + " differ from those in the comments of " +
                      file.name + "; write both again or remove the sidecar");
    };
    require(file.kind == seam.kind, "kind and lattice");
    require(file.lattice && file.lattice->a() == seam.lattice.a(), "kind and lattice");
    require(file.lattice && file.lattice->b() == seam.lattice.b(), "kind and lattice");
    require(file.vertex_pairs == seam.vertex_pairs, "vertex pairs");
    require(file.edge_pairs == seam.edge_pairs, "edge pairs");
    require(file.sites == seam.sites, "sites");
}

}  // namespace

TileFile decode_obj(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice) {
    const EncodedFile& obj = files.front();
    FileTileBuilder builder{.name = obj.path, .index_base = 1, .notes = {.short_edges = 0}};
    std::array<NoteTable, 2> pairs = pair_notes();
    const auto take_comment = [&](const LineScanner& scanner, std::string_view word,
                                  std::span<const std::string_view> words) {
        return builder.take_comment(scanner, word, words) ||
               take_note_line(pairs, scanner, word, words, builder.index_base);
    };
    ObjContent content = ObjParser(obj, take_comment).parse();
    give_polygons(content, builder);
    give_pairs(pairs, builder);
    const bool is_own = has_seam(builder);
    const EncodedFile* materials = nullptr;
    for (const EncodedFile& file : files) {
        if (file.path.ends_with(".mtl")) materials = &file;
        if (!file.path.ends_with(".seam.json")) continue;
        Seam seam = decode_seam(file.path, file.bytes);
        if (is_own) {
            compare_seam(builder, seam, file.path);
        } else {
            take_seam(builder, std::move(seam));
        }
    }
    TileFile file = finish(std::move(builder), lattice, plane::Precision::kDouble);
    // The appearance of files of other programs is free.
    if (is_own) require_own_appearance(file.tile, content.appearance, obj.path, materials);
    file.shown = shown_phases(file.tile, material_runs(content.appearance));
    return file;
}

SurfaceList decode_obj_surfaces(const EncodedFile& obj) {
    SurfaceListBuilder builder;
    ObjContent content =
        ObjParser(obj, std::bind_front(&SurfaceListBuilder::take_comment, &builder)).parse();
    space::TileSurface& surface = builder.list.surface;
    surface.points = std::move(content.points);
    surface.faces = std::move(content.faces);
    // The groups of polyhedra are their cells; the cells behind a boundary are listed.
    const std::vector<int>& groups = content.appearance.groups;
    std::size_t group = 0;
    for (int f = 0; f < surface.n_faces(); ++f) {
        while (group < groups.size() && groups[group] <= f) ++group;
        surface.cell.push_back(static_cast<SiteId>(group) - 1);
    }
    return std::move(builder).finish(obj.path);
}

}  // namespace pcvt
