#include "io/openfoam/foam_polyhedra.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/forms/material_words.hpp"
#include "io/openfoam/foam_lists.hpp"
#include "io/openfoam/foam_reader.hpp"
#include "io/openfoam/foam_text.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/mesh/polyhedral_assembly.hpp"
#include "mesher/space/mesh/short_edges.hpp"

namespace pcvt {
namespace {

constexpr const char* kKind = "polyhedra";
/// The law that the numbers of a file may break before the mesh is proved.
constexpr const char* kFaceOrder = "(1), order of the faces";

/// The numbers in the comments of a case.
struct Notes {
    std::vector<double> lattice;
    std::vector<double> short_edges;
    std::vector<double> sites;
    std::vector<double> weights;
    CellMaterials materials;
};

Notes read_notes(const EncodedFile& boundary) {
    Notes notes;
    struct Row {
        std::string_view key;
        std::size_t n_numbers;
        std::vector<double>& numbers;
    };
    const Row rows[] = {{"lattice", 9, notes.lattice},
                        {"short_edges", 1, notes.short_edges},
                        {"site", 3, notes.sites},
                        {"weight", 1, notes.weights}};
    read_foam_notes(boundary, [&](const LineScanner& scanner, std::string_view key,
                                  std::span<const std::string_view> values) {
        if (take_material(scanner, key, values, notes.materials)) return;
        for (const Row& row : rows) {
            if (row.key != key) continue;
            if (values.size() != row.n_numbers) {
                scanner.throw_bad_file("the comment has not " + std::to_string(row.n_numbers) +
                                       " numbers; write the file again with pcvt");
            }
            for (const std::string_view value : values) {
                row.numbers.push_back(scanner.number(value));
            }
        }
    });
    return notes;
}

space::Lattice lattice_of(const Notes& notes, const std::string& path) {
    if (notes.lattice.size() != 9) {
        throw BadFile(path + ": names not one lattice; write the case again with pcvt");
    }
    const Eigen::Map<const Eigen::Matrix3d> periods(notes.lattice.data());
    try {
        return {periods.col(0), periods.col(1), periods.col(2)};
    } catch (const InvalidInput& fault) {
        throw BadFile(path + ": " + fault.what());
    }
}

/// PolyhedralMesh::short_edges, which a case without removed edges does not state.
double short_edges_of(const Notes& notes, const std::string& path) {
    const std::vector<double>& numbers = notes.short_edges;
    if (numbers.empty()) return 0;
    if (numbers.size() > 1 || !(numbers[0] >= 0 && numbers[0] <= space::kLongestShortEdge)) {
        throw BadFile(path + ": " + kShortEdgesRange);
    }
    return numbers[0];
}

/// Proves of the numbers of a mesh all that the assembly of its cells needs.
void require_numbers(const std::vector<EncodedFile>& files, const FiniteVolumeMesh& mesh) {
    require_face_order(mesh, kFaceOrder);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        if (mesh.faces.size(f) >= 3) continue;
        throw BadFile(foam_mesh_file(files, "faces").path +
                      ": a face has not three points; write the case again with pcvt");
    }
}

std::vector<FoamZone> phase_zones(const CellMaterials& materials) {
    std::vector<FoamZone> zones;
    for (const std::string& name : materials.phase_names) zones.push_back({phase_group(name), {}});
    for (int s = 0; s < std::ssize(materials.site_phase); ++s) {
        zones[materials.site_phase[s]].cells.push_back(s);
    }
    return zones;
}

}  // namespace

FoamCase foam_case(const SpaceTile& tile) {
    Eigen::Matrix3d periods;
    for (int k = 0; k < 3; ++k) periods.col(k) = tile.mesh.lattice.periods()[k];
    std::string notes = foam_notes(kKind, periods);
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
            .zones = phase_zones(tile.materials)};
}

bool is_foam_of_polyhedra(const std::vector<EncodedFile>& files) {
    return std::any_of(files.begin(), files.end(), [](const EncodedFile& file) {
        return file.path.ends_with(std::string(kMeshFolder) + "/boundary") &&
               file.bytes.find(foam_kind_note(kKind)) != std::string::npos;
    });
}

SpaceTile decode_foam_polyhedra(const std::vector<EncodedFile>& files, double tolerance) {
    const EncodedFile& boundary = foam_boundary(files);
    Notes notes = read_notes(boundary);
    const space::Lattice lattice = lattice_of(notes, boundary.path);
    const double short_edges = short_edges_of(notes, boundary.path);
    SpaceTile tile{.mesh = {decode_foam_mesh(files, 3), lattice}};
    space::PolyhedralMesh& mesh = tile.mesh;
    mesh.short_edges = short_edges;
    require_numbers(files, mesh);
    mesh.n_cells = last_cell(mesh) + 1;
    for (FiniteVolumePatch& patch : mesh.patches) {
        if (patch.kind != PatchKind::kCyclic) continue;
        patch.name = seam_name(std::span<const int>(patch.offset));
        patch.separation = lattice.translation(patch.offset_as<space::Offset>());
    }
    space::PolyhedralMesh joined = assembled_mesh(lattice, polyhedron_list(mesh), tolerance);
    mesh.point_orbit = std::move(joined.point_orbit);
    mesh.point_offset = std::move(joined.point_offset);
    tile.sites = Eigen::Map<const space::Points>(notes.sites.data(), 3,
                                                 static_cast<Eigen::Index>(notes.sites.size() / 3));
    tile.weights =
        Eigen::Map<const Eigen::VectorXd>(notes.weights.data(), std::ssize(notes.weights));
    mesh.piece_cell = cells_of_pieces(lattice, tile.sites);
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
