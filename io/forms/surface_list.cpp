#include "io/forms/surface_list.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/colours/site_classes.hpp"
#include "io/forms/material_words.hpp"
#include "io/forms/tile_file.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/choices.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/mesh/polyhedral_assembly.hpp"

namespace pcvt {
namespace {

/// The most corners of a face; no cell of a CVT comes near it.
constexpr int kMostCorners = 10'000;
/// The comment of the kind follows the explanation.
constexpr std::size_t kHeadBytes = 1024;

space::Points points_of(const std::vector<double>& numbers) {
    return Eigen::Map<const space::Points>(numbers.data(), 3,
                                           static_cast<Eigen::Index>(numbers.size() / 3));
}

}  // namespace

SurfaceList surface_list(const space::PolyhedralMesh& mesh, const space::Points& sites,
                         SurfaceForm form) {
    if (form == SurfaceForm::kBoundary) return {form, tile_surface(mesh, sites)};
    space::PolyhedronList cells = polyhedron_list(mesh);
    space::TileSurface surface{.lattice = mesh.lattice};
    surface.points = std::move(cells.points);
    surface.faces = std::move(cells.faces);
    for (int s = 0; s < cells.n_cells(); ++s) {
        surface.cell.insert(surface.cell.end(),
                            static_cast<std::size_t>(cells.cell_begin[s + 1] - cells.cell_begin[s]),
                            s);
    }
    surface.sites = sites;
    return {form, std::move(surface)};
}

Colouring default_colouring(const CellMaterials& materials) {
    if (!materials.site_phase.empty()) return Colouring::kPhase;
    return materials.site_orientation.empty() ? Colouring::kFaces : Colouring::kOrientation;
}

std::vector<int> cells_apart(const space::PolyhedralMesh& mesh) {
    std::vector<std::pair<SiteId, SiteId>> pairs;
    for (int f = 0; f < mesh.n_inner_faces(); ++f) {
        pairs.emplace_back(mesh.owner[f], mesh.neighbour[f]);
    }
    for (const FiniteVolumePatch& patch : mesh.patches) {
        const FiniteVolumePatch& partner = mesh.patches[patch.partner];
        for (int k = 0; k < patch.n_faces; ++k) {
            pairs.emplace_back(mesh.owner[patch.first_face + k],
                               mesh.owner[partner.first_face + k]);
        }
    }
    return classes_of_neighbours(std::move(pairs), mesh.n_cells);
}

SurfaceList with_materials(SurfaceList list, const SpaceTile& tile, Colouring colouring) {
    list.weights = tile.weights;
    list.materials = tile.materials;
    list.colouring = colouring;
    if (colouring == Colouring::kCells) list.cell_class = cells_apart(tile.mesh);
    return list;
}

void require_shown_materials(const SurfaceList& list, const std::string& path) {
    const bool are_missing =
        (list.colouring == Colouring::kPhase && list.materials.site_phase.empty()) ||
        (list.colouring == Colouring::kOrientation && list.materials.site_orientation.empty());
    if (!are_missing) return;
    throw BadFile(path + ": the colours show materials that are missing; write the file again");
}

bool SurfaceListBuilder::take_comment(const LineScanner& scanner, std::string_view key,
                                      std::span<const std::string_view> words) {
    if (key == "kind") {
        const bool is_boundary = words.size() == 1 && words[0] == "boundary";
        list.form = is_boundary ? SurfaceForm::kBoundary : SurfaceForm::kCells;
        return true;
    }
    if (key == "colouring") {
        const ColouringRow* const row =
            words.size() == 1 ? find_word(kColourings, words[0]) : nullptr;
        if (row == nullptr || !row->in_space) {
            scanner.throw_bad_file("pcvt does not know this colouring; write the file again");
        }
        list.colouring = row->colouring;
        return true;
    }
    if (take_material(scanner, key, words, list.materials)) return true;
    if (!take_note_line(notes_, scanner, key, words, 1)) return false;
    if (key == "lattice") {
        const std::vector<double> n =
            std::exchange(std::get<std::vector<double>>(notes_[0].numbers), {});
        try {
            list.surface.lattice = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}};
        } catch (const InvalidInput& fault) {
            scanner.throw_bad_file(fault.what());
        }
        has_lattice_ = true;
    }
    return true;
}

SurfaceList SurfaceListBuilder::finish(const std::string& path) && {
    if (!has_lattice_) throw BadFile(path + ": the lattice is missing; give the whole file");
    const std::vector<double>& sites = notes_[1].reals();
    if (!sites.empty()) list.surface.sites = points_of(sites);
    const std::vector<double>& weights = notes_[4].reals();
    list.weights = Eigen::Map<const Eigen::VectorXd>(weights.data(), std::ssize(weights));
    if (list.weights.size() != 0 && list.weights.size() != list.surface.sites.cols()) {
        throw BadFile(path + ": the weights are not as many as the sites; write the file again");
    }
    require_materials(path, list.materials, list.surface.sites.cols());
    require_shown_materials(list, path);
    if (list.form == SurfaceForm::kBoundary && list.surface.partner.empty()) {
        list.surface.cell = notes_[2].integers();
        link_pairs(path);
    }
    return std::move(list);
}

void SurfaceListBuilder::link_pairs(const std::string& path) {
    space::TileSurface& surface = list.surface;
    const int n = surface.n_faces();
    surface.partner.assign(static_cast<std::size_t>(n), -1);
    surface.offset.resize(static_cast<std::size_t>(n));
    if (static_cast<int>(surface.cell.size()) != n) {
        throw BadFile(path + ": the cells are not as many as the faces; give the whole file");
    }
    const std::vector<int>& pairs = notes_[3].integers();
    for (std::size_t k = 0; k < pairs.size(); k += notes_[3].width) {
        const int f = pairs[k];
        const int g = pairs[k + 1];
        if (std::max(f, g) >= n) {
            throw BadFile(path + ": a face_pair names a face beyond the last one, " +
                          std::to_string(n) + "; give the whole file");
        }
        const space::Offset offset = stated_offset(pairs[k + 2], pairs[k + 3], pairs[k + 4], path);
        surface.partner[f] = g;
        surface.partner[g] = f;
        surface.offset[f] = offset;
        surface.offset[g] = -offset;
    }
}

space::Offset stated_offset(int i, int j, int k, const std::string& path) {
    for (const int n : {i, j, k}) {
        if (n >= -kLargestOffset && n <= kLargestOffset) continue;
        throw BadFile(path + ": an offset is beyond 2^28; write the file again with pcvt");
    }
    return {i, j, k};
}

void require_faces(const SurfaceList& list, const std::string& path) {
    const Faces& faces = list.surface.faces;
    const auto n_points = static_cast<int>(list.surface.points.size());
    for (int f = 0; f < faces.n_faces(); ++f) {
        checkpoint_each(f);
        const std::string name = path + ": face " + std::to_string(f);
        const int size = faces.size(f);
        if (size < 3 || size > kMostCorners) {
            throw BadFile(name + " has " + std::to_string(size) +
                          " corners; give polygons with at least 3");
        }
        for (const int v : faces[f]) {
            if (v >= 0 && v < n_points) continue;
            throw BadFile(name + " names a point that does not exist; give the whole file");
        }
    }
    if (faces.n_faces() == 0) throw BadFile(path + ": holds no face; give the whole file");
}

space::PolyhedralMesh assembled_cells(SurfaceList list, const std::string& path) {
    require_faces(list, path);
    space::TileSurface& surface = list.surface;
    space::PolyhedronList cells;
    cells.points = std::move(surface.points);
    for (int f = 0; f < surface.n_faces(); ++f) {
        const SiteId cell = surface.cell[f];
        const bool begins = cell == cells.n_cells();
        if (cell < 0 || (!begins && cell != cells.n_cells() - 1)) {
            throw BadFile(
                path + ": the faces of cell " + std::to_string(cell) +
                " do not follow those of the cell before; write the file again with pcvt");
        }
        if (begins) cells.cell_begin.push_back(f);
        cells.cell_begin.back() = f + 1;
    }
    cells.faces = std::move(surface.faces);
    if (surface.sites.cols() != cells.n_cells()) {
        throw BadFile(path + ": has " + std::to_string(surface.sites.cols()) + " sites of " +
                      std::to_string(cells.n_cells()) + " cells; write the file again with pcvt");
    }
    space::PolyhedralMesh mesh = assembled_mesh(surface.lattice, cells);
    mesh.piece_cell = cells_of_pieces(mesh.lattice, surface.sites);
    return mesh;
}

bool states_surfaces(std::string_view bytes) {
    const std::string_view head = bytes.substr(0, kHeadBytes);
    return head.find(" pcvt kind polyhedra\n") != std::string_view::npos ||
           head.find(" pcvt kind boundary\n") != std::string_view::npos;
}

}  // namespace pcvt
