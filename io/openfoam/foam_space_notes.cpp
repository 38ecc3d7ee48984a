#include "io/openfoam/foam_space_notes.hpp"

#include <algorithm>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/forms/material_words.hpp"
#include "io/openfoam/foam_lists.hpp"
#include "io/openfoam/foam_reader.hpp"
#include "io/openfoam/foam_text.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/space/mesh/polyhedral_assembly.hpp"

namespace pcvt {
namespace {

/// The law that the numbers of a file may break before the mesh is proved.
constexpr const char* kFaceOrder = "(1), order of the faces";

/// Proves of the numbers of a mesh all that the assembly of its cells needs.
void require_numbers(const std::vector<EncodedFile>& files, const FiniteVolumeMesh& mesh) {
    require_face_order(mesh, kFaceOrder);
    for (int f = 0; f < mesh.n_faces(); ++f) {
        if (mesh.faces.size(f) >= 3) continue;
        throw BadFile(foam_mesh_file(files, "faces").path +
                      ": a face has not three points; write the case again with pcvt");
    }
}

}  // namespace

std::string foam_space_notes(std::string_view kind, const space::Lattice& lattice) {
    Eigen::Matrix3d periods;
    for (int k = 0; k < 3; ++k) periods.col(k) = lattice.periods()[k];
    return foam_notes(kind, periods);
}

bool is_foam_of(std::string_view kind, const std::vector<EncodedFile>& files) {
    const std::string note = foam_kind_note(kind);
    return std::any_of(files.begin(), files.end(), [&](const EncodedFile& file) {
        return file.path.ends_with(std::string(kMeshFolder) + "/boundary") &&
               file.bytes.find(note) != std::string::npos;
    });
}

FoamSpaceNotes read_foam_space_notes(const EncodedFile& boundary) {
    FoamSpaceNotes notes;
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
        if (key == "cell_tetrahedra") {
            for (const std::string_view value : values) {
                notes.tetrahedra.push_back(scanner.integer(value));
            }
        }
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

space::Lattice foam_lattice(const FoamSpaceNotes& notes, const std::string& path) {
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

space::PolyhedralMesh foam_cells(const std::vector<EncodedFile>& files,
                                 const space::Lattice& lattice, double tolerance) {
    space::PolyhedralMesh mesh{decode_foam_mesh(files, 3), lattice};
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
    return mesh;
}

std::vector<FoamZone> phase_zones(const std::vector<std::string>& names,
                                  const std::vector<int>& phase_of_cell) {
    std::vector<FoamZone> zones;
    for (const std::string& name : names) zones.push_back({phase_group(name), {}});
    for (int c = 0; c < std::ssize(phase_of_cell); ++c) {
        zones[phase_of_cell[c]].cells.push_back(c);
    }
    return zones;
}

}  // namespace pcvt
