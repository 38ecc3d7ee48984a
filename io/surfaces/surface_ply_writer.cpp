#include "io/surfaces/surface_ply_writer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/surfaces/surface_parts.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// The largest number of corners of a list whose length is a uchar.
constexpr int kMostByUchar = 255;

template <class Number>
void append_word(std::string& text, Number number) {
    append_number(text, number);
    text += ' ';
}

void append_vector(std::string& text, const space::Vec3& vector) {
    for (const double x : vector) append_word(text, x);
    text.back() = '\n';
}

std::string colour_words(Colour colour) {
    std::string text;
    for (const double part : {colour.r, colour.g, colour.b}) {
        append_word(text, static_cast<int>(std::lround(255 * part)));
    }
    return text;
}

std::string header(const SurfaceList& list) {
    const bool is_boundary = list.form == SurfaceForm::kBoundary;
    std::string text = "ply\nformat ascii 1.0\ncomment " +
                       std::string(is_boundary ? "The boundary of a periodic tile of polyhedra"
                                               : "The cells of a periodic tile of polyhedra") +
                       ", written by pcvt\ncomment pcvt kind " +
                       (is_boundary ? "boundary" : "polyhedra") + "\ncomment pcvt lattice ";
    for (const space::Vec3& period : list.lattice.periods()) {
        for (const double x : period) append_word(text, x);
    }
    text.back() = '\n';
    const std::string position = "property double x\nproperty double y\nproperty double z\n";
    text += "element vertex " + std::to_string(list.points.size()) + '\n' + position;
    int most_corners = 0;
    for (int f = 0; f < list.faces.n_faces(); ++f) {
        most_corners = std::max(most_corners, list.faces.size(f));
    }
    text += "element face " + std::to_string(list.faces.n_faces()) + "\nproperty list ";
    text += most_corners <= kMostByUchar ? "uchar" : "int";
    text +=
        " int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "property int cell\n";
    if (is_boundary) {
        text +=
            "property int partner\nproperty int offset_i\nproperty int offset_j\n"
            "property int offset_k\n";
    }
    text += "element site " + std::to_string(list.sites.cols()) + '\n' + position;
    return text + "end_header\n";
}

void append_face(std::string& text, const SurfaceList& list, int f, const std::string& colour) {
    append_word(text, list.faces.size(f));
    for (const int v : list.faces[f]) append_word(text, v);
    text += colour;
    append_word(text, list.cell[f]);
    if (list.form == SurfaceForm::kBoundary) {
        const space::Offset offset = list.offset[f];
        for (const int number : {list.partner[f], offset.i, offset.j, offset.k}) {
            append_word(text, number);
        }
    }
    text.back() = '\n';
}

}  // namespace

std::vector<EncodedFile> encode_surface_ply(const SurfaceList& list, const std::string& path) {
    const SurfaceParts parts = surface_parts(list);
    std::string text = header(list);
    for (const space::Vec3& p : list.points) append_vector(text, p);
    for (const SurfacePart& part : parts.parts) {
        checkpoint();
        const std::string colour = colour_words(parts.classes[part.colour].colour);
        for (int f = part.first_face; f < part.first_face + part.n_faces; ++f) {
            append_face(text, list, f, colour);
        }
    }
    for (const auto& site : list.sites.colwise()) append_vector(text, site);
    return only_file(path, std::move(text));
}

}  // namespace pcvt
