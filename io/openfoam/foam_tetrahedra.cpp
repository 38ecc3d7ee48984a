#include "io/openfoam/foam_tetrahedra.hpp"

#include <algorithm>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/file_fields.hpp"
#include "io/forms/material_words.hpp"
#include "io/forms/point_offsets.hpp"
#include "io/openfoam/foam_fields.hpp"
#include "io/openfoam/foam_lists.hpp"
#include "io/openfoam/foam_space_notes.hpp"
#include "io/openfoam/foam_writer.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/space/mesh/cell_faces.hpp"
#include "mesher/space/mesh/polyhedral_assembly.hpp"
#include "mesher/space/proof/polyhedral_proof.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"

namespace pcvt {
namespace {

constexpr const char* kKind = "tetrahedra";

space::PolyhedralMesh polyhedra_of(const space::TetrahedralMesh& mesh) {
    space::PolyhedronList list;
    list.points = mesh.points;
    for (const std::array<int, 4>& corners : mesh.tetrahedra) {
        for (const std::array<int, 3>& face : space::kOutwardSides) {
            list.faces.add(std::array{corners[face[0]], corners[face[1]], corners[face[2]]});
        }
        list.cell_begin.push_back(list.faces.n_faces());
    }
    return assembled_mesh(mesh.lattice, list);
}

/// The zones of the cells and of their phases.
std::vector<FoamZone> zones_of(const space::TetrahedralMesh& mesh, const CellMaterials& materials) {
    std::vector<FoamZone> zones;
    std::vector<int> phases;
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        const SiteId cell = mesh.cell[t];
        while (std::ssize(zones) <= cell) {
            zones.push_back({std::string(kCellSet) + std::to_string(zones.size()), {}});
        }
        zones[cell].cells.push_back(t);
        if (!materials.site_phase.empty()) phases.push_back(materials.site_phase[cell]);
    }
    std::vector<FoamZone> of_phases = phase_zones(materials.phase_names, phases);
    std::move(of_phases.begin(), of_phases.end(), std::back_inserter(zones));
    return zones;
}

/// The files of a case whose cells are the tetrahedra of a mesh.
/// @param cells  these cells.
std::vector<EncodedFile> encode_cells(const space::PolyhedralMesh& cells,
                                      const space::TetrahedralMesh& mesh,
                                      const CellMaterials& materials, const std::string& folder) {
    std::vector<FoamZone> zones = zones_of(mesh, materials);
    std::string notes = foam_space_notes(kKind, mesh.lattice);
    for (SiteId s = 0; s <= mesh.cell.back(); ++s) {
        notes += "// pcvt cell_tetrahedra " + std::to_string(zones[s].cells.size()) + "\n";
    }
    append_materials(notes, "// pcvt ", materials);
    return encode_foam({.cells = FoamCells::kPolyhedra,
                        .mesh = cells,
                        .flow = cell_flow(BeltramiFlow(mesh.lattice), cells),
                        .notes = std::move(notes),
                        .zones = std::move(zones)},
                       folder);
}

/// The corners of a cell, by rising numbers.
/// @throws BadFile  unless it is a tetrahedron.
std::array<int, 4> corners_of(const space::PolyhedralMesh& cells,
                              std::span<const space::FaceUse> uses, const std::string& path) {
    std::vector<int> corners;
    for (const space::FaceUse& use : uses) {
        const auto face = cells.faces[use.face];
        corners.insert(corners.end(), face.begin(), face.end());
    }
    const std::size_t n_uses = corners.size();
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    if (uses.size() != 4 || n_uses != 12 || corners.size() != 4) {
        throw BadFile(path + ": a cell is not a tetrahedron; write the case again with pcvt");
    }
    return {corners[0], corners[1], corners[2], corners[3]};
}

/// The cell of each tetrahedron.
std::vector<SiteId> cells_of(const std::vector<int>& counts, int n_tetrahedra,
                             const std::string& path) {
    std::vector<SiteId> cell;
    for (std::size_t s = 0; s < counts.size(); ++s) {
        const long left = n_tetrahedra - std::ssize(cell);
        if (counts[s] < 1 || counts[s] > left) break;
        cell.insert(cell.end(), static_cast<std::size_t>(counts[s]), static_cast<SiteId>(s));
    }
    if (std::ssize(cell) == n_tetrahedra && cell.back() + 1 == std::ssize(counts)) return cell;
    throw BadFile(
        path +
        ": the numbers of tetrahedra in the cells, cell_tetrahedra, do not sum to that of "
        "the tetrahedra; write the case again with pcvt");
}

}  // namespace

std::vector<EncodedFile> encode_foam_tetrahedra(const space::TetrahedralMesh& mesh,
                                                const CellMaterials* materials,
                                                const std::string& folder) {
    return encode_cells(polyhedra_of(mesh), mesh,
                        materials == nullptr ? CellMaterials() : *materials, folder);
}

bool is_foam_of_tetrahedra(const std::vector<EncodedFile>& files) {
    return is_foam_of(kKind, files);
}

space::TetrahedralMesh with_sorted_corners(space::TetrahedralMesh mesh) {
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        checkpoint_each(t);
        std::array<int, 4>& corners = mesh.tetrahedra[t];
        const bool was_positive = tetrahedron_volume(mesh, t) > 0;
        std::sort(corners.begin(), corners.end());
        const bool is_positive = tetrahedron_volume(mesh, t) > 0;
        if (was_positive != is_positive) std::swap(corners[2], corners[3]);
    }
    return mesh;
}

TetrahedralTile decode_foam_tetrahedra(const std::vector<EncodedFile>& files, double tolerance) {
    const EncodedFile& boundary = foam_boundary(files);
    FoamSpaceNotes notes = read_foam_space_notes(boundary);
    const space::PolyhedralMesh cells =
        foam_cells(files, foam_lattice(notes, boundary.path), tolerance);
    TetrahedralTile tile{.mesh = {.lattice = cells.lattice, .points = cells.points},
                         .materials = std::move(notes.materials)};
    space::TetrahedralMesh& mesh = tile.mesh;
    const space::CellFaces uses(cells);
    for (int t = 0; t < cells.n_cells; ++t) {
        checkpoint_each(t);
        mesh.tetrahedra.push_back(corners_of(cells, uses[t], boundary.path));
        if (tetrahedron_volume(mesh, t) < 0) {
            std::swap(mesh.tetrahedra[t][2], mesh.tetrahedra[t][3]);
        }
    }
    mesh.cell = cells_of(notes.tetrahedra, cells.n_cells, boundary.path);
    // Number the nodes by the first points of their orbits.
    std::vector<int> number(cells.points.size(), -1);
    int n_nodes = 0;
    for (const int orbit : cells.point_orbit) {
        if (number[orbit] < 0) number[orbit] = n_nodes++;
        mesh.point_site.push_back(number[orbit]);
    }
    find_point_offsets(boundary.path, mesh);
    require_materials(boundary.path, tile.materials, mesh.cell.back() + 1);
    return tile;
}

void compare_foam_tetrahedra(const std::vector<EncodedFile>& files, const TetrahedralTile& tile,
                             double tolerance) {
    const space::PolyhedralMesh cells = foam_cells(files, tile.mesh.lattice, tolerance);
    prove_polyhedra(cells, tolerance);
    compare_files(files, encode_cells(cells, tile.mesh, tile.materials, foam_folder(files)),
                  foam_fields);
}

}  // namespace pcvt
