#include "io/solvers/vtu_grid.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "io/colours/pole_colours.hpp"
#include "io/forms/site_notes.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/space/mesh/cell_faces.hpp"
#include "mesher/space/proof/tetrahedral_proof.hpp"

namespace pcvt {
namespace {

/// The arrays that all grids have.
VtuGrid grid_of(std::string_view mark, ElementMesh mesh) {
    VtuGrid grid{.mark = mark, .points = std::move(mesh.nodes), .cells = std::move(mesh.elements)};
    grid.field_data.push_back(
        {"Float64", "PeriodicLattice", std::move(mesh.periods), mesh.dimension});
    grid.point_data.push_back({"Int64", "PeriodicPointIds", std::move(mesh.orbit)});
    grid.point_data.push_back({"Int32", "PeriodicOffset", std::move(mesh.offsets), mesh.dimension});
    if (!mesh.node_site.empty()) {
        grid.point_data.push_back({"Int32", "CellId", std::move(mesh.node_site)});
    }
    if (!mesh.element_site.empty()) {
        grid.cell_data.push_back({"Int32", "CellId", std::move(mesh.element_site)});
    }
    return grid;
}

/// A note as an array: of each site a tuple, of the tile the numbers in one line.
VtuData note_data(StatedNote stated) {
    const SiteNote& note = *stated.note;
    const auto width = static_cast<int>(note.n_parts);
    return {note.of_integers ? "Int32" : "Float64", note.array, std::move(stated.numbers),
            note.of_each_site ? width : 1, width};
}

/// Adds the names of holes, and the hole and the two points of each edge on one.
void add_holes(const plane::Tile& tile, std::vector<VtuData>& data) {
    if (tile.holes.empty()) return;
    data.push_back({"UInt8", "HoleNames", tile.holes});
    std::vector<int> edges;
    for (const auto& [wall, v, w] : tile.wall_edges) {
        if (wall.is_hole()) edges.insert(edges.end(), {wall.hole(), v, w});
    }
    data.push_back({"Int32", "HoleEdges", std::move(edges), 3});
}

/// Adds a number of each site as that of its elements.
void add_numbers_of_sites(std::string_view name, std::span<const int> of_site,
                          std::vector<VtuData>& data) {
    if (of_site.empty()) return;
    auto numbers = std::get<std::vector<int>>(data.front().values);
    // In a file under proof, the numbers are those of its own cells.
    const auto is_known = [&](int cell) { return std::cmp_less(cell, of_site.size()); };
    for (int& cell : numbers) cell = is_known(cell) ? of_site[cell] : -1;
    data.push_back({"Int32", name, std::move(numbers)});
}

/// Adds the names of the phases and that of each site, at the front.
void add_phases(const CellMaterials& materials, VtuGrid& grid) {
    grid.field_data.insert(grid.field_data.begin(),
                           {{"UInt8", "PhaseNames", materials.phase_names},
                            {"Int32", "SitePhases", materials.site_phase}});
}

/// Adds the materials of the cells to their elements.
/// @param sites  the cell of each element.
void add_materials(const CellMaterials& materials, const std::vector<SiteId>& sites,
                   VtuGrid& grid) {
    if (!materials.site_phase.empty()) {
        add_phases(materials, grid);
        std::vector<int> phases;
        for (const SiteId s : sites) phases.push_back(materials.site_phase[s]);
        grid.cell_data.push_back({"Int32", "Phase", std::move(phases)});
    }
    if (materials.site_orientation.empty()) return;
    std::vector<std::array<int, 3>> colour_of;
    for (const BungeAngles& of_cell : materials.site_orientation) {
        const auto colour = pole_colour(of_cell);
        colour_of.push_back({colour[0], colour[1], colour[2]});
    }
    std::vector<double> angles;
    std::vector<int> colours;
    for (const SiteId s : sites) {
        const BungeAngles& of_cell = materials.site_orientation[s];
        angles.insert(angles.end(), {of_cell.phi1, of_cell.Phi, of_cell.phi2});
        colours.insert(colours.end(), colour_of[s].begin(), colour_of[s].end());
    }
    grid.cell_data.push_back({"Float64", "Orientation", std::move(angles), 3});
    grid.cell_data.push_back({"UInt8", "IPFz", std::move(colours), 3});
}

}  // namespace

VtuGrid vtu_grid(const plane::Tile& tile, const CellMaterials* materials,
                 std::span<const int> site_orbits) {
    VtuGrid grid = grid_of(kTileVtuMark, element_mesh(tile, solver_nodes(tile)));
    std::vector<int> ids(grid.points.size());
    std::iota(ids.begin(), ids.end(), 0);
    grid.point_data.insert(grid.point_data.begin(), {"Int64", "GlobalIds", std::move(ids)});
    const bool has_phases = materials != nullptr && !materials->site_phase.empty();
    if (has_phases) add_phases(*materials, grid);
    for (StatedNote& stated : stated_notes(tile, true)) {
        grid.field_data.push_back(note_data(std::move(stated)));
    }
    add_holes(tile, grid.field_data);
    add_numbers_of_sites("Orbit", site_orbits, grid.cell_data);
    if (has_phases) add_numbers_of_sites("Phase", materials->site_phase, grid.cell_data);
    return grid;
}

VtuGrid vtu_grid(const SpaceTile& tile) {
    const space::PolyhedronList cells = polyhedron_list(tile.mesh);
    VtuGrid grid = grid_of(kPolyhedraVtuMark, element_mesh(tile.mesh, cells));
    if (tile.mesh.short_edges > 0) {
        grid.field_data.push_back({"Float64", "ShortEdges", std::vector{tile.mesh.short_edges}});
    }
    if (const space::Metric& metric = tile.mesh.metric; !metric.is_round()) {
        const space::Vec3& axis = metric.axis();
        std::vector<double> numbers{metric.ratio(), axis.x(), axis.y(), axis.z()};
        grid.field_data.push_back({"Float64", "Metric", std::move(numbers), 1, 4});
    }
    std::vector<int> n_faces;
    for (int s = 0; s < cells.n_cells(); ++s) {
        checkpoint_each(s);
        n_faces.push_back(cells.cell_begin[s + 1] - cells.cell_begin[s]);
        grid.polyhedra.corners.push_back(n_faces.back());
        for (int f = cells.cell_begin[s]; f < cells.cell_begin[s + 1]; ++f) {
            const std::span<const int> face = cells.faces[f];
            grid.polyhedra.corners.push_back(cells.faces.size(f));
            grid.polyhedra.corners.insert(grid.polyhedra.corners.end(), face.begin(), face.end());
        }
        grid.polyhedra.close();
    }
    grid.cell_data.push_back({"Int32", "Faces", std::move(n_faces)});
    std::vector<double> volumes;
    for (const space::CellBody& body : cell_bodies(tile.mesh)) volumes.push_back(body.volume);
    grid.cell_data.push_back({"Float64", "Volume", std::move(volumes)});
    if (tile.sites.cols() > 0) {
        std::vector<double> sites(tile.sites.data(), tile.sites.data() + tile.sites.size());
        grid.cell_data.push_back({"Float64", "Site", std::move(sites), 3});
    }
    if (tile.weights.size() > 0) {
        std::vector<double> weights(tile.weights.data(), tile.weights.data() + tile.weights.size());
        grid.cell_data.push_back({"Float64", "Weight", std::move(weights)});
    }
    std::vector<SiteId> of_cells(static_cast<std::size_t>(cells.n_cells()));
    std::iota(of_cells.begin(), of_cells.end(), 0);
    add_materials(tile.materials, of_cells, grid);
    return grid;
}

VtuGrid vtu_grid(const space::TetrahedralMesh& mesh, const CellMaterials* materials) {
    VtuGrid grid = grid_of(kTetrahedraVtuMark, element_mesh(mesh));
    if (mesh.cell.empty()) return grid;
    if (materials != nullptr) add_materials(*materials, mesh.cell, grid);
    std::vector<double> volumes;
    for (int t = 0; t < mesh.n_tetrahedra(); ++t) {
        checkpoint_each(t);
        volumes.resize(std::max(volumes.size(), static_cast<std::size_t>(mesh.cell[t]) + 1), 0);
        volumes[mesh.cell[t]] += tetrahedron_volume(mesh, t);
    }
    grid.field_data.push_back({"Float64", "CellVolumes", std::move(volumes)});
    return grid;
}

}  // namespace pcvt
