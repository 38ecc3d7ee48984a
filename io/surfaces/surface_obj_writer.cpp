#include "io/surfaces/surface_obj_writer.hpp"

#include <filesystem>
#include <initializer_list>
#include <utility>

#include "io/bytes/extension.hpp"
#include "io/bytes/text.hpp"
#include "io/surfaces/surface_parts.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

constexpr int kCellsALine = 16;

constexpr const char* kCellsExplanation =
    "# A periodic tile of polyhedra, written by pcvt. Comments that begin with \"# pcvt\" hold:\n"
    "#   lattice ax ay az bx by bz cx cy cz   the period vectors a, b and c\n"
    "#   site x y z                           the site of cell 0, 1, ...\n"
    "# Each group is a cell; neighbours share points, and each has the face between them.\n";
constexpr const char* kBoundaryExplanation =
    "# The boundary of a periodic tile of polyhedra, written by pcvt. Comments that begin with\n"
    "# \"# pcvt\" hold:\n"
    "#   lattice ax ay az bx by bz cx cy cz   the period vectors a, b and c\n"
    "#   site x y z                           the site of cell 0, 1, ...\n"
    "#   cells s ...                          the cell behind each face, from 0\n"
    "#   face_pair f g i j k                  face f + i a + j b + k c is face g, from 1\n"
    "# Each group is a side of the seam.\n";

template <class Numbers>
void append_words(std::string& text, const Numbers& numbers) {
    for (const auto number : numbers) {
        text += ' ';
        append_number(text, number);
    }
    text += '\n';
}

void append_lattice(std::string& text, const space::Lattice& lattice) {
    text += "# pcvt lattice";
    for (const space::Vec3& period : lattice.periods()) {
        for (const double x : period) {
            text += ' ';
            append_number(text, x);
        }
    }
    text += '\n';
}

void append_pairs(std::string& text, const SurfaceList& list) {
    const int n_faces = list.faces.n_faces();
    for (int f = 0; f < n_faces; ++f) {
        if (f % kCellsALine == 0) text += f == 0 ? "# pcvt cells" : "\n# pcvt cells";
        text += ' ';
        append_number(text, list.cell[f]);
    }
    text += '\n';
    for (int f = 0; f < n_faces; ++f) {
        const space::Offset offset = list.offset[f];
        if (offset < space::Offset{}) continue;
        text += "# pcvt face_pair";
        append_words(text, std::initializer_list<int>{f + 1, list.partner[f] + 1, offset.i,
                                                      offset.j, offset.k});
    }
}

std::string obj_text(const SurfaceList& list, const SurfaceParts& parts,
                     const std::string& material_file) {
    const bool is_boundary = list.form == SurfaceForm::kBoundary;
    std::string text = is_boundary ? kBoundaryExplanation : kCellsExplanation;
    text += is_boundary ? "# pcvt kind boundary\n" : "# pcvt kind polyhedra\n";
    append_lattice(text, list.lattice);
    for (const auto& site : list.sites.colwise()) {
        text += "# pcvt site";
        append_words(text, site);
    }
    if (is_boundary) append_pairs(text, list);
    text += "mtllib " + material_file + "\n";
    for (const space::Vec3& p : list.points) {
        text += 'v';
        append_words(text, p);
    }
    for (const SurfacePart& part : parts.parts) {
        checkpoint();
        text += "g " + part.name + "\nusemtl " + parts.classes[part.colour].name + "\n";
        for (int f = part.first_face; f < part.first_face + part.n_faces; ++f) {
            text += 'f';
            for (const int v : list.faces[f]) {
                text += ' ';
                append_number(text, v + 1);
            }
            text += '\n';
        }
    }
    return text;
}

std::string mtl_text(const SurfaceParts& parts) {
    std::string text = "# Materials of a periodic tile, written by pcvt\n";
    for (const ColourClass& material : parts.classes) {
        text += "newmtl " + material.name + "\nKd";
        append_words(text, std::initializer_list<double>{material.colour.r, material.colour.g,
                                                         material.colour.b});
    }
    return text;
}

}  // namespace

std::vector<std::string> surface_obj_paths(const std::string& path) {
    return {path, one_word_beside(path, ".mtl")};
}

std::vector<EncodedFile> encode_surface_obj(const SurfaceList& list, const std::string& path) {
    const SurfaceParts parts = surface_parts(list);
    const std::vector<std::string> paths = surface_obj_paths(path);
    const std::string material_file = std::filesystem::path(paths[1]).filename().string();
    std::vector<EncodedFile> files = only_file(paths[0], obj_text(list, parts, material_file));
    files.push_back({paths[1], mtl_text(parts)});
    return files;
}

}  // namespace pcvt
