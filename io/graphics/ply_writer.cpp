#include "io/graphics/ply_writer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/colours/palette.hpp"
#include "io/forms/finite.hpp"
#include "io/forms/plane_surface.hpp"
#include "io/forms/triangle_fan.hpp"
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

void end_line(std::string& text) { text.back() = '\n'; }

void append_real(std::string& text, double x, bool is_single) {
    is_single ? append_word(text, static_cast<float>(x)) : append_word(text, x);
}

/// The notes that are properties of an element.
std::vector<const NoteTable*> properties_of(const SurfaceMesh& mesh, NoteOf of) {
    std::vector<const NoteTable*> result;
    for (const NoteTable& note : mesh.notes) {
        if (note.of == of && !note.columns.empty()) result.push_back(&note);
    }
    return result;
}

/// Appends a declaration for each name in `names`, which blanks separate.
void declare(std::string& text, std::string_view type, std::string_view names) {
    while (!names.empty()) {
        const std::size_t length = std::min(names.find(' '), names.size());
        (((text += "property ") += type) += ' ') += names.substr(0, length);
        text += '\n';
        names.remove_prefix(std::min(length + 1, names.size()));
    }
}

void declare_rows(std::string& text, const SurfaceMesh& mesh, NoteOf of,
                  const std::vector<int>& class_of) {
    if (!class_of.empty()) declare(text, "uchar", "red green blue");
    for (const NoteTable* note : properties_of(mesh, of)) declare(text, "int", note->columns);
}

std::string header(const SurfaceMesh& mesh) {
    std::string text = "ply\nformat ascii 1.0\n";
    append_lines(text, "comment ", mesh.explanation);
    text += "comment pcvt kind " + mesh.kind + '\n';
    for (const NoteTable& note : mesh.notes) {
        if (note.of == NoteOf::kMesh) append_note(text, "comment pcvt ", note, 0);
    }
    append_lines(text, "comment pcvt ", mesh.statements);
    const char* const real = mesh.is_single ? "float" : "double";
    text += "element vertex " + std::to_string(mesh.points.size()) + '\n';
    declare(text, real, "x y z");
    declare_rows(text, mesh, NoteOf::kVertices, mesh.vertex_class);
    // Faces are lists, with a length as narrow as the largest face permits.
    int most_corners = 0;
    for (int f = 0; f < mesh.faces.n_faces(); ++f) {
        most_corners = std::max(most_corners, mesh.faces.size(f));
    }
    text += "element face " + std::to_string(mesh.faces.n_faces()) + '\n';
    declare(text, most_corners <= kMostByUchar ? "list uchar int" : "list int int",
            "vertex_indices");
    declare_rows(text, mesh, NoteOf::kFaces, mesh.face_class);
    for (const NoteTable* sites : properties_of(mesh, NoteOf::kSites)) {
        text += "element site " + std::to_string(sites->reals().size() / sites->width) + '\n';
        declare(text, real, sites->columns);
    }
    return text + "end_header\n";
}

/// Appends the ends of the lines of an element: its colour, and its properties.
class RowEnds {
   public:
    RowEnds(const SurfaceMesh& mesh, NoteOf of, const std::vector<int>& class_of)
        : class_of_(class_of) {
        for (const ColourClass& shown : mesh.classes) colours_.push_back(words(shown.colour));
        for (const NoteTable* note : properties_of(mesh, of)) {
            columns_.push_back({note->integers().data(), std::max<std::size_t>(note->width, 1)});
        }
    }

    void append(std::string& text, int row) const {
        if (!class_of_.empty()) text += colours_[class_of_[row]];
        for (const auto& [numbers, width] : columns_) {
            const int* const begin = numbers + width * static_cast<std::size_t>(row);
            for (std::size_t k = 0; k < width; ++k) append_word(text, begin[k]);
        }
        end_line(text);
    }

   private:
    struct Columns {
        const int* numbers;
        std::size_t width;
    };

    const std::vector<int>& class_of_;
    std::vector<std::string> colours_;
    std::vector<Columns> columns_;
};

std::string ply_text(const SurfaceMesh& mesh) {
    std::string text = header(mesh);
    const RowEnds of_vertices(mesh, NoteOf::kVertices, mesh.vertex_class);
    for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v) {
        checkpoint_each(v);
        for (const double x : mesh.points[v]) append_real(text, x, mesh.is_single);
        of_vertices.append(text, v);
    }
    const RowEnds of_faces(mesh, NoteOf::kFaces, mesh.face_class);
    for (int f = 0; f < mesh.faces.n_faces(); ++f) {
        checkpoint_each(f);
        append_word(text, mesh.faces.size(f));
        for (const int v : mesh.faces[f]) append_word(text, v);
        of_faces.append(text, f);
    }
    for (const NoteTable* sites : properties_of(mesh, NoteOf::kSites)) {
        const std::vector<double>& numbers = sites->reals();
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            append_real(text, numbers[k], mesh.is_single);
            if ((k + 1) % sites->width == 0) end_line(text);
        }
    }
    return text;
}

/// Makes the faces of cells triangles, each with the site and the colour of its cell.
void split_cells(SurfaceMesh& mesh, const plane::Tile& tile, const std::string& path) {
    const std::vector<Point32> points = single_precision_points(tile, path);
    if (tile.kind != plane::MeshKind::kVoronoi) return;
    std::vector<SiteId> sites;
    mesh.faces = {};
    std::vector<int>& corners = mesh.faces.corners;
    const std::vector<int> class_of = std::exchange(mesh.face_class, {});
    for (int f = 0; f < tile.n_faces(); ++f) {
        checkpoint_each(f);
        const std::size_t begin = corners.size();
        append_fan(tile, f, f - 1, points, corners, path);
        for (std::size_t c = begin; c < corners.size(); c += 3) {
            mesh.faces.begin.push_back(static_cast<int>(c) + 3);
            sites.push_back(tile.face_site[f]);
            mesh.face_class.push_back(class_of[f]);
        }
    }
    const auto of_faces =
        std::find_if(mesh.notes.begin(), mesh.notes.end(),
                     [](const NoteTable& note) { return note.of == NoteOf::kFaces; });
    if (of_faces != mesh.notes.end()) of_faces->numbers = std::move(sites);
}

}  // namespace

std::vector<EncodedFile> encode_ply_mesh(const SurfaceMesh& mesh, const std::string& path) {
    return only_file(path, ply_text(mesh));
}

std::vector<EncodedFile> encode_ply(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    require_finite(tile);
    TileColours colours =
        tile_colours(tile, options.colouring.value_or(Colouring::kSides), options.quantities());
    SurfaceMesh mesh = surface_mesh(tile, SeamForm::kColumns);
    // Faces, or vertices, without colours are plain.
    const int plain = static_cast<int>(colours.classes.size());
    colours.classes.push_back({.colour = kPlain, .name = {}, .label = {}});
    mesh.classes = std::move(colours.classes);
    mesh.vertex_class.assign(mesh.points.size(), plain);
    mesh.face_class.assign(static_cast<std::size_t>(mesh.faces.n_faces()), plain);
    (faces_have_sites(tile.kind) ? mesh.face_class : mesh.vertex_class) =
        std::move(colours.class_of);
    mesh.is_single = options.single_precision;
    if (mesh.is_single) split_cells(mesh, tile, path);
    return encode_ply_mesh(mesh, path);
}

}  // namespace pcvt
