#include "io/surfaces/surface_list.hpp"

#include <utility>

#include "io/bytes/bad_file.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/space/mesh/polyhedral_assembly.hpp"

namespace pcvt {
namespace {

/// The most corners of a face; no cell of a CVT comes near it.
constexpr int kMostCorners = 10'000;

void require_indices(const SurfaceList& list, const std::string& path) {
    const auto n_points = static_cast<int>(list.points.size());
    for (int f = 0; f < list.faces.n_faces(); ++f) {
        checkpoint_each(f);
        const std::string name = path + ": face " + std::to_string(f);
        const int size = list.faces.size(f);
        if (size < 3 || size > kMostCorners) {
            throw BadFile(name + " has " + std::to_string(size) +
                          " corners; give polygons with at least 3");
        }
        for (const int v : list.faces[f]) {
            if (v >= 0 && v < n_points) continue;
            throw BadFile(name + " names a point that does not exist; give the whole file");
        }
    }
    if (list.faces.n_faces() == 0) throw BadFile(path + ": holds no face; give the whole file");
}

SpaceTile cells_of(SurfaceList list, const std::string& path) {
    space::PolyhedronList cells;
    cells.points = std::move(list.points);
    for (int f = 0; f < list.faces.n_faces(); ++f) {
        const SiteId cell = list.cell[f];
        const bool begins = cell == cells.n_cells();
        if (!begins && cell != cells.n_cells() - 1) {
            throw BadFile(
                path + ": the faces of cell " + std::to_string(cell) +
                " do not follow those of the cell before; write the file again with pcvt");
        }
        if (begins) cells.cell_begin.push_back(f);
        cells.cell_begin.back() = f + 1;
    }
    cells.faces = std::move(list.faces);
    if (list.sites.cols() != cells.n_cells()) {
        throw BadFile(path + ": has " + std::to_string(list.sites.cols()) + " sites of " +
                      std::to_string(cells.n_cells()) + " cells; write the file again with pcvt");
    }
    SpaceTile tile{.mesh = assembled_mesh(list.lattice, cells)};
    tile.sites = std::move(list.sites);
    return tile;
}

}  // namespace

SurfaceList surface_list(const SpaceTile& tile, SurfaceForm form) {
    if (form == SurfaceForm::kBoundary) {
        return surface_list(tile_surface(tile.mesh, tile.sites));
    }
    space::PolyhedronList cells = polyhedron_list(tile.mesh);
    SurfaceList list;
    list.lattice = tile.mesh.lattice;
    list.points = std::move(cells.points);
    list.faces = std::move(cells.faces);
    for (int s = 0; s < cells.n_cells(); ++s) {
        list.cell.insert(list.cell.end(),
                         static_cast<std::size_t>(cells.cell_begin[s + 1] - cells.cell_begin[s]),
                         s);
    }
    list.sites = tile.sites;
    return list;
}

SurfaceList surface_list(const space::TileSurface& surface) {
    SurfaceList list;
    list.form = SurfaceForm::kBoundary;
    list.lattice = surface.lattice;
    list.points = surface.points;
    list.faces = surface.faces;
    list.cell = surface.cell;
    list.partner = surface.partner;
    list.offset = surface.offset;
    list.sites = surface.sites;
    return list;
}

SurfaceContent surface_content(SurfaceList list, const std::string& path) {
    require_indices(list, path);
    if (list.form == SurfaceForm::kCells) return cells_of(std::move(list), path);
    space::TileSurface surface{.lattice = list.lattice};
    surface.points = std::move(list.points);
    surface.faces = std::move(list.faces);
    surface.cell = std::move(list.cell);
    surface.partner = std::move(list.partner);
    surface.offset = std::move(list.offset);
    surface.sites = std::move(list.sites);
    return surface;
}

}  // namespace pcvt
