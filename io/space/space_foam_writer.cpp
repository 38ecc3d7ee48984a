#include "io/space/space_foam_writer.hpp"

#include <filesystem>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/openfoam/foam_case.hpp"
#include "io/openfoam/foam_text.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/space/mesh/beltrami_flow.hpp"
#include "mesher/space/mesh/cell_faces.hpp"

namespace pcvt {
namespace {

/// ParaView and VTK open a case by an empty file NAME.foam in its folder.
const char* const kMarker = "";

std::string count_line(std::size_t n) { return std::to_string(n) + "\n(\n"; }

void append_numbers(std::string& text, const space::Vec3& vector) {
    for (const double x : vector) {
        text += ' ';
        append_number(text, x);
    }
}

std::string encode_points(const space::PolyhedralMesh& mesh) {
    std::string text =
        foam_header("vectorField", kMeshFolder, "points") + count_line(mesh.points.size());
    for (const space::Vec3& p : mesh.points) {
        append_foam_vector(text, {p.x(), p.y(), p.z()});
        text += '\n';
    }
    return text + ")\n";
}

std::string encode_faces(const space::PolyhedralMesh& mesh) {
    std::string text =
        foam_header("faceList", kMeshFolder, "faces") + count_line(mesh.owner.size());
    for (int f = 0; f < mesh.n_faces(); ++f) {
        checkpoint_each(f);
        append_number(text, mesh.faces.size(f));
        char before = '(';
        for (const int v : mesh.faces[f]) {
            text += before;
            append_number(text, v);
            before = ' ';
        }
        text += ")\n";
    }
    return text + ")\n";
}

std::string encode_labels(const space::PolyhedralMesh& mesh, const std::string& name,
                          const std::vector<int>& cells) {
    const std::string note = "nPoints:" + std::to_string(mesh.n_points()) +
                             " nCells:" + std::to_string(mesh.n_cells) +
                             " nFaces:" + std::to_string(mesh.n_faces()) +
                             " nInternalFaces:" + std::to_string(mesh.n_inner_faces());
    std::string text = foam_header("labelList", kMeshFolder, name, note) + count_line(cells.size());
    for (const int cell : cells) {
        append_number(text, cell);
        text += '\n';
    }
    return text + ")\n";
}

void append_patch(std::string& text, const space::PolyhedralMesh& mesh,
                  const space::PolyhedralPatch& patch) {
    const space::Vec3 separation = mesh.lattice.translation(patch.offset);
    text += "    " + seam_name(patch.offset) +
            "\n    {\n        type            cyclic;\n        nFaces          " +
            std::to_string(patch.n_faces) + ";\n        startFace       " +
            std::to_string(patch.first_face) +
            ";\n        matchTolerance  1e-06;\n        transform       translational;\n"
            "        neighbourPatch  " +
            seam_name(-patch.offset) + ";\n        separationVector ";
    append_foam_vector(text, {separation.x(), separation.y(), separation.z()});
    text += ";\n    }\n";
}

std::string encode_boundary(const SpaceTile& tile) {
    const space::PolyhedralMesh& mesh = tile.mesh;
    std::string text =
        foam_header("polyBoundaryMesh", kMeshFolder, "boundary") +
        "// A periodic tile, written by pcvt: seam_I_J_K is answered at + I a + J b + K c\n" +
        kSpaceKind + "// pcvt lattice";
    for (const space::Vec3& period : mesh.lattice.periods()) append_numbers(text, period);
    text += '\n';
    if (mesh.short_edges > 0) {
        text += "// pcvt short_edges ";
        append_number(text, mesh.short_edges);
        text += '\n';
    }
    for (const auto& site : tile.sites.colwise()) {
        text += "// pcvt site";
        append_numbers(text, site);
        text += '\n';
    }
    text += count_line(mesh.patches.size());
    for (const space::PolyhedralPatch& patch : mesh.patches) append_patch(text, mesh, patch);
    return text + ")\n";
}

std::string boundary_field(const space::PolyhedralMesh& mesh) {
    std::string text = "boundaryField\n{\n";
    for (const space::PolyhedralPatch& patch : mesh.patches) {
        text += "    " + seam_name(patch.offset) + " { type cyclic; }\n";
    }
    return text + "}\n";
}

std::string encode_velocity(const space::BeltramiFlow& flow, const space::PolyhedralMesh& mesh,
                            const std::vector<space::CellBody>& bodies) {
    std::string text = foam_field_head("vector", "U", "[0 1 -1 0 0 0 0]", bodies.size());
    for (const space::CellBody& body : bodies) {
        const space::Vec3 u = flow.velocity(body.centroid);
        append_foam_vector(text, {u.x(), u.y(), u.z()});
        text += '\n';
    }
    return text + ");\n" + boundary_field(mesh);
}

std::string encode_pressure(const space::PolyhedralMesh& mesh) {
    return foam_header("volScalarField", "0", "p") +
           "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\n" + boundary_field(mesh);
}

std::string encode_transport(const space::BeltramiFlow& flow) {
    return foam_header("dictionary", "constant", "transportProperties") +
           foam_fill(
               "// U falls as exp(-$RATE nu t): to 1/e at the end of the run.\n"
               "transportModel Newtonian;\n"
               "nu [0 2 -1 0 0 0 0] $NU;\n",
               {{"RATE", flow.rate()}, {"NU", 1 / (flow.rate() * flow.turn_time())}});
}

}  // namespace

std::vector<std::string> space_foam_paths(const std::string& folder) {
    std::vector<std::string> paths;
    for (const char* name :
         {"constant/polyMesh/points", "constant/polyMesh/faces", "constant/polyMesh/owner",
          "constant/polyMesh/neighbour", "constant/polyMesh/boundary",
          "constant/transportProperties", "constant/turbulenceProperties", "system/controlDict",
          "system/fvSchemes", "system/fvSolution", "0/U", "0/p"}) {
        paths.push_back(folder + "/" + name);
    }
    paths.push_back(folder + "/" + std::filesystem::path(folder).filename().string());
    return paths;
}

std::vector<EncodedFile> encode_space_foam(const SpaceTile& tile, const std::string& folder) {
    const space::PolyhedralMesh& mesh = tile.mesh;
    const space::BeltramiFlow flow(mesh.lattice);
    const std::vector<space::CellBody> bodies = cell_bodies(mesh);
    // The contents have the order of space_foam_paths().
    std::vector<std::string> contents = {
        encode_points(mesh),
        encode_faces(mesh),
        encode_labels(mesh, "owner", mesh.owner),
        encode_labels(mesh, "neighbour", mesh.neighbour),
        encode_boundary(tile),
        encode_transport(flow),
        foam_turbulence(),
        foam_control(flow.turn_time(), courant_rate(flow, mesh, bodies)),
        foam_schemes(),
        foam_solution(),
        encode_velocity(flow, mesh, bodies),
        encode_pressure(mesh),
        kMarker};
    const std::vector<std::string> paths = space_foam_paths(folder);
    std::vector<EncodedFile> files;
    for (std::size_t k = 0; k < paths.size(); ++k) {
        files.push_back({paths[k], std::move(contents[k])});
    }
    return files;
}

}  // namespace pcvt
