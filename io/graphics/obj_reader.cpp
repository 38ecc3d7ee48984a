#include "io/graphics/obj_reader.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/graphics/obj_appearance.hpp"
#include "io/graphics/seam_json.hpp"
#include "io/tiles/file_tile_builder.hpp"
#include "io/tiles/material_words.hpp"

namespace pcvt {
namespace {

constexpr std::array<std::string_view, 5> kPassedOver{"vn", "vp", "o", "g", "s"};

/// Reads one OBJ line by line.
class ObjParser {
   public:
    ObjParser(const std::string& name, std::string_view text)
        : scanner_(name, text), file_{.name = name, .index_base = 1, .notes = {.short_edges = 0}} {}

    FileTileBuilder parse() {
        while (scanner_.next()) parse_line();
        return std::move(file_);
    }

    /// @pre parse() has returned.
    const ObjAppearance& appearance() const { return appearance_; }

   private:
    using Words = std::span<const std::string_view>;

    void parse_line() {
        // Comments of pcvt hold the seam; the rest of a line after # is skipped.
        Words words = scanner_.words();
        if (words.size() >= 2 && words[0] == "#" && words[1] == "pcvt") {
            parse_seam(words.subspan(2));
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
            appearance_.materials.push_back({word_of(words), file_.faces.n_faces()});
        } else if (statement == "mtllib") {
            appearance_.libraries.emplace_back(word_of(words));
        } else if (std::find(kPassedOver.begin(), kPassedOver.end(), statement) ==
                   kPassedOver.end()) {
            scanner_.throw_bad_file(in_quotes(statement) +
                                    " is not a supported statement; remove the line");
        }
    }

    void parse_vertex(Words words) {
        if (words.size() != 3 && words.size() != 6) {
            scanner_.throw_bad_file(
                "a vertex has 3 numbers, or 6 with its colour; write \"v x y 0\"");
        }
        std::array<double, 6> numbers{};
        for (std::size_t k = 0; k < words.size(); ++k) numbers[k] = scanner_.number(words[k]);
        if (numbers[2] != 0)
            scanner_.throw_bad_file("z is not 0; move the tile to the plane z = 0");
        file_.points.emplace_back(numbers[0], numbers[1]);
    }

    /// Returns the only word of a statement; empty if there are more.
    static std::string_view word_of(Words words) { return words.size() == 1 ? words[0] : ""; }

    void parse_texture(Words words) {
        plane::TextureCoordinate& coordinate = appearance_.coordinates.emplace_back();
        for (std::size_t k = 0; k < std::min(words.size(), coordinate.size()); ++k) {
            coordinate[k] = static_cast<float>(scanner_.number(words[k]));
        }
    }

    void parse_face(Words words) {
        std::vector<int> corners;
        for (const std::string_view word : words) corners.push_back(parse_corner(word));
        file_.add_face(corners, scanner_.line());
    }

    /// Returns the vertex counted from 0. An index out of range is returned as it is, negative or
    /// too large, and finish() refuses it.
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
                const int n_vertices = static_cast<int>(file_.points.size());
                return indices[0] > 0 ? indices[0] - 1 : n_vertices + indices[0];
            }
            rest.remove_prefix(length + 1);
        }
        scanner_.throw_bad_file(in_quotes(word) +
                                " is not a corner; write v, v/vt, v//vn or v/vt/vn");
    }

    void note_texture(int vertex, int coordinate) {
        appearance_.has_corners = true;
        if (vertex != coordinate && appearance_.other_index_line == 0) {
            appearance_.other_index_line = scanner_.line();
        }
    }

    /// Reads the words of a comment after "# pcvt".
    void parse_seam(Words words) {
        // The first word says which part of the seam follows.
        if (words.empty())
            scanner_.throw_bad_file("a word is missing after \"# pcvt\"; remove the line");
        const std::string_view key = words.front();
        const Words values = words.subspan(1);
        // Vertices count from 1 in the file, sites from 0.
        if (file_.take_comment(scanner_, key, values)) return;
        if (key == "vertex_pair") {
            const auto [v, w, i, j] = integers<4>(values);
            file_.vertex_pairs.push_back({from_zero(v), from_zero(w), {i, j}});
        } else if (key == "edge_pair") {
            const auto [v0, v1, w0, w1, i, j] = integers<6>(values);
            file_.edge_pairs.push_back({.v0 = from_zero(v0),
                                        .v1 = from_zero(v1),
                                        .w0 = from_zero(w0),
                                        .w1 = from_zero(w1),
                                        .offset = {i, j}});
        } else {
            scanner_.throw_bad_file("pcvt does not know " + in_quotes(key) + "; remove the line");
        }
    }

    template <std::size_t kCount>
    std::array<int, kCount> integers(Words values) {
        if (values.size() != kCount) {
            scanner_.throw_bad_file("a pair has " + std::to_string(kCount) + " numbers here, not " +
                                    std::to_string(values.size()) +
                                    "; write the file again with pcvt");
        }
        std::array<int, kCount> numbers{};
        for (std::size_t k = 0; k < kCount; ++k) numbers[k] = scanner_.integer(values[k]);
        return numbers;
    }

    /// Returns the index counted from 0 of an index counted from 1.
    int from_zero(int index) {
        if (index < 1)
            scanner_.throw_bad_file("vertex " + std::to_string(index) +
                                    " does not exist; count from 1");
        return index - 1;
    }

    LineScanner scanner_;
    FileTileBuilder file_;
    ObjAppearance appearance_;
};

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
    refuse_binary(obj.path, obj.bytes, "give a Wavefront OBJ");
    ObjParser parser(obj.path, obj.bytes);
    FileTileBuilder builder = parser.parse();
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
    if (is_own) require_own_appearance(file.tile, parser.appearance(), obj.path, materials);
    file.shown = shown_phases(file.tile, material_names(parser.appearance(), file.tile.n_faces()));
    return file;
}

}  // namespace pcvt
