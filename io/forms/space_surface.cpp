#include "io/forms/space_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "io/colours/cell_colours.hpp"
#include "io/forms/material_words.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/space/mesh/cell_sites.hpp"

namespace pcvt {
namespace {

constexpr const char* kCellsExplanation =
    "A periodic tile of polyhedra, written by pcvt. Comments that begin with \"# pcvt\" hold:\n"
    "  lattice ax ay az bx by bz cx cy cz   the period vectors a, b and c\n"
    "  site x y z                           the site of cell 0, 1, ...\n"
    "Each group is a cell; neighbours share points, and each has the face between them.\n";
constexpr const char* kBoundaryExplanation =
    "The boundary of a periodic tile of polyhedra, written by pcvt. Comments that begin with\n"
    "\"# pcvt\" hold:\n"
    "  lattice ax ay az bx by bz cx cy cz   the period vectors a, b and c\n"
    "  site x y z                           the site of cell 0, 1, ...\n"
    "  cells s ...                          the cell behind each face, from 0\n"
    "  face_pair f g i j k                  face f + i a + j b + k c is face g, from 1\n"
    "Each group is a side of the seam.\n";

constexpr const char* kWeightsExplanation =
    "The weights of the sites are lengths squared: a cell has the points p with the least\n"
    "|p - site|^2 - weight.\n";

/// Returns the words of a list that are not numbers.
std::string statements_of(const SurfaceList& list) {
    std::string text;
    if (list.colouring != Colouring::kFaces) {
        text = std::string("colouring ") + colouring_row(list.colouring).word + "\n";
    }
    append_materials(text, "", list.materials);
    return text;
}

std::string explanation_of(const SurfaceList& list, SeamForm seam) {
    const bool is_boundary = list.form == SurfaceForm::kBoundary;
    if (seam == SeamForm::kLines) {
        std::string text = is_boundary ? kBoundaryExplanation : kCellsExplanation;
        return list.weights.size() > 0 ? text + kWeightsExplanation : text;
    }
    return is_boundary ? "The boundary of a periodic tile of polyhedra, written by pcvt\n"
                       : "The cells of a periodic tile of polyhedra, written by pcvt\n";
}

/// Makes a group of each run of faces with equal keys.
template <class Key>
void add_groups(SurfaceMesh& mesh, const Key& key) {
    for (int f = 0; f < mesh.faces.n_faces(); ++f) {
        checkpoint_each(f);
        if (f == 0 || key(f) != key(f - 1)) mesh.groups.push_back({.name = {}, .first_face = f});
    }
}

/// The volumes of the cells, one a group, as fans of triangles from a corner of the cell.
/// @param is_single  whether a file holds the points in single precision, so that its reader finds
///                   the same volumes.
std::vector<double> group_volumes(const SurfaceMesh& mesh, bool is_single) {
    const auto point = [&](int v) {
        const space::Vec3& p = mesh.points[v];
        return is_single ? space::Vec3(p.cast<float>().cast<double>()) : p;
    };
    std::vector<double> volumes;
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        const int first = mesh.groups[g].first_face;
        const space::Vec3 apex = point(mesh.faces[first].front());
        double volume = 0;
        for (int f = first; f < mesh.group_end(g); ++f) {
            const auto corners = mesh.faces[f];
            const space::Vec3 p = point(corners[0]) - apex;
            for (std::size_t k = 2; k < corners.size(); ++k) {
                const space::Vec3 q = point(corners[k - 1]) - apex;
                volume += p.cross(q).dot(point(corners[k]) - apex) / 6;
            }
        }
        volumes.push_back(volume);
    }
    return volumes;
}

/// The name of a cell, or of a piece of one: cell_12, or cell_12_1 and cell_12_2.
std::string cell_name(const std::vector<SiteId>& of_pieces, int number) {
    if (of_pieces.empty()) return std::string(kCellSet) + std::to_string(number);
    const SiteId cell = of_pieces[number];
    const auto [first, last] = std::equal_range(of_pieces.begin(), of_pieces.end(), cell);
    const auto piece = number - static_cast<int>(first - of_pieces.begin()) + 1;
    const std::string name = std::string(kCellSet) + std::to_string(cell);
    return last - first == 1 ? name : name + "_" + std::to_string(piece);
}

void add_cells(SurfaceMesh& mesh, const SurfaceList& list, SeamForm seam,
               const std::vector<SiteId>& cell) {
    add_groups(mesh, [&](int f) { return cell[f]; });
    CellQuantities cells{.n_faces = {}, .classes = list.cell_class, .materials = &list.materials};
    const std::vector<SiteId> of_pieces = cells_of_pieces(list.surface.lattice, list.surface.sites);
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        FaceGroup& group = mesh.groups[g];
        group.name = cell_name(of_pieces, cell[group.first_face]);
        cells.n_faces.push_back(mesh.group_end(g) - group.first_face);
    }
    if (list.colouring == Colouring::kSize)
        cells.volumes = group_volumes(mesh, seam == SeamForm::kNone);
    TileColours colours = cell_colours(list.colouring, cells);
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        mesh.face_class.insert(mesh.face_class.end(), static_cast<std::size_t>(cells.n_faces[g]),
                               colours.class_of[g]);
    }
    mesh.classes = std::move(colours.classes);
}

void add_sides(SurfaceMesh& mesh, const std::vector<space::Offset>& offsets) {
    add_groups(mesh, [&](int f) { return offsets[f]; });
    // Both sides of a seam have one colour.
    std::map<space::Offset, int> class_of;
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        FaceGroup& group = mesh.groups[g];
        const space::Offset offset = offsets[group.first_face];
        group.name = seam_name(offset);
        const int next = static_cast<int>(mesh.classes.size());
        const auto [found, is_new] = class_of.try_emplace(std::max(offset, -offset), next);
        mesh.face_class.insert(mesh.face_class.end(),
                               static_cast<std::size_t>(mesh.group_end(g) - group.first_face),
                               found->second);
        if (!is_new) continue;
        mesh.classes.push_back({.colour = seam_colour(static_cast<std::size_t>(next)),
                                .name = seam_name(found->first),
                                .label = {}});
    }
}

NoteTable lattice_note(const space::Lattice& lattice) {
    std::vector<double> numbers;
    for (const space::Vec3& period : lattice.periods()) {
        numbers.insert(numbers.end(), period.begin(), period.end());
    }
    const std::size_t width = numbers.size();
    return {.word = "lattice", .width = width, .numbers = std::move(numbers)};
}

NoteTable face_pairs(const space::TileSurface& surface) {
    std::vector<int> rows;
    for (int f = 0; f < surface.n_faces(); ++f) {
        const auto [i, j, k] = surface.offset[f];
        if (surface.offset[f] < space::Offset{}) continue;
        rows.insert(rows.end(), {f, surface.partner[f], i, j, k});
    }
    return {.word = "face_pair", .width = 5, .n_indices = 2, .numbers = std::move(rows)};
}

NoteTable face_partners(const space::TileSurface& surface) {
    std::vector<int> rows;
    for (int f = 0; f < surface.n_faces(); ++f) {
        const auto [i, j, k] = surface.offset[f];
        rows.insert(rows.end(), {surface.partner[f], i, j, k});
    }
    return {.columns = "partner offset_i offset_j offset_k",
            .of = NoteOf::kFaces,
            .width = 4,
            .numbers = std::move(rows)};
}

}  // namespace

SurfaceMesh surface_mesh(SurfaceList list, SeamForm seam) {
    space::TileSurface& surface = list.surface;
    const bool is_boundary = list.form == SurfaceForm::kBoundary;
    SurfaceMesh mesh{.explanation = explanation_of(list, seam),
                     .kind = is_boundary ? "boundary" : "polyhedra"};
    mesh.statements = statements_of(list);
    mesh.notes.push_back(lattice_note(surface.lattice));
    const double* const sites = surface.sites.data();
    mesh.notes.push_back({.word = "site",
                          .columns = "x y z",
                          .of = NoteOf::kSites,
                          .width = 3,
                          .numbers = std::vector<double>(sites, sites + surface.sites.size())});
    mesh.notes.push_back(
        {.word = "weights",
         .numbers = std::vector<double>(list.weights.begin(), list.weights.end())});
    if (is_boundary && seam == SeamForm::kLines) {
        mesh.notes.push_back({.word = "cells", .of = NoteOf::kFaces, .numbers = surface.cell});
        mesh.notes.push_back(face_pairs(surface));
    } else if (seam == SeamForm::kColumns) {
        mesh.notes.push_back({.columns = "cell", .of = NoteOf::kFaces, .numbers = surface.cell});
        if (is_boundary) mesh.notes.push_back(face_partners(surface));
    }
    mesh.points = std::move(surface.points);
    mesh.faces = std::move(surface.faces);
    if (is_boundary) {
        add_sides(mesh, surface.offset);
    } else {
        add_cells(mesh, list, seam, surface.cell);
    }
    return mesh;
}

}  // namespace pcvt
