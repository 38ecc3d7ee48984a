#include "io/openfoam/foam_polyhedra.hpp"

#include <string>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/forms/material_words.hpp"
#include "io/openfoam/foam_lists.hpp"
#include "io/openfoam/foam_space_notes.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/mesh/short_edges.hpp"

namespace pcvt {
namespace {

constexpr const char* kKind = "polyhedra";

/// PolyhedralMesh::short_edges, which a case without removed edges does not state.
double short_edges_of(const FoamSpaceNotes& notes, const std::string& path) {
    const std::vector<double>& numbers = notes.short_edges;
    if (numbers.empty()) return 0;
    if (numbers.size() > 1 || !(numbers[0] >= 0 && numbers[0] <= space::kLongestShortEdge)) {
        throw BadFile(path + ": " + kShortEdgesRange);
    }
    return numbers[0];
}

}  // namespace

FoamCase foam_case(const SpaceTile& tile) {
    std::string notes = foam_space_notes(kKind, tile.mesh.lattice);
    if (tile.mesh.short_edges > 0) {
        append_number(notes += "// pcvt short_edges ", tile.mesh.short_edges);
        notes += '\n';
    }
    for (const auto& site : tile.sites.colwise()) {
        notes += "// pcvt site";
        for (const double x : site) append_number(notes += ' ', x);
        notes += '\n';
    }
    for (const double weight : tile.weights) {
        append_number(notes += "// pcvt weight ", weight);
        notes += '\n';
    }
    append_materials(notes, "// pcvt ", tile.materials);
    return {.cells = FoamCells::kPolyhedra,
            .mesh = tile.mesh,
            .flow = cell_flow(BeltramiFlow(tile.mesh.lattice), tile.mesh),
            .notes = std::move(notes),
            .zones = phase_zones(tile.materials.phase_names, tile.materials.site_phase)};
}

bool is_foam_of_polyhedra(const std::vector<EncodedFile>& files) {
    return is_foam_of(kKind, files);
}

SpaceTile decode_foam_polyhedra(const std::vector<EncodedFile>& files, double tolerance) {
    const EncodedFile& boundary = foam_boundary(files);
    FoamSpaceNotes notes = read_foam_space_notes(boundary);
    const double short_edges = short_edges_of(notes, boundary.path);
    SpaceTile tile{.mesh = foam_cells(files, foam_lattice(notes, boundary.path), tolerance)};
    space::PolyhedralMesh& mesh = tile.mesh;
    mesh.short_edges = short_edges;
    tile.sites = Eigen::Map<const space::Points>(notes.sites.data(), 3,
                                                 static_cast<Eigen::Index>(notes.sites.size() / 3));
    tile.weights =
        Eigen::Map<const Eigen::VectorXd>(notes.weights.data(), std::ssize(notes.weights));
    mesh.piece_cell = cells_of_pieces(mesh.lattice, tile.sites);
    if (tile.weights.size() != 0 && tile.weights.size() != tile.sites.cols()) {
        throw BadFile(boundary.path + ": there are " + std::to_string(tile.weights.size()) +
                      " weights of " + std::to_string(tile.sites.cols()) +
                      " sites; write the case again with pcvt");
    }
    tile.materials = std::move(notes.materials);
    if (!tile.materials.site_phase.empty()) foam_mesh_file(files, "cellZones");
    require_materials(boundary.path, tile.materials, mesh.n_cells);
    return tile;
}

}  // namespace pcvt
