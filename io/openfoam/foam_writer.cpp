#include "io/openfoam/foam_writer.hpp"

#include <filesystem>

#include "io/bytes/text.hpp"
#include "io/openfoam/foam_settings.hpp"
#include "io/openfoam/foam_text.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

std::string count_line(std::size_t n) { return std::to_string(n) + "\n(\n"; }

/// Whether two points have the same digits in x and y.
bool same_place(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return p.x() == q.x() && p.y() == q.y();
}

std::string encode_points(const FoamCase& foam) {
    const std::vector<Eigen::Vector3d>& points = foam.mesh.points;
    std::string text =
        foam_header("vectorField", kMeshFolder, "points") + count_line(points.size());
    // The front of a layer repeats x and y of the back, whose digits are copied.
    const std::size_t half = points.size() / 2;
    std::vector<std::size_t> places;
    places.reserve(half + 1);
    for (std::size_t v = 0; v < points.size(); ++v) {
        checkpoint_each(static_cast<long>(v));
        text += '(';
        if (v <= half) places.push_back(text.size());
        if (v >= half && same_place(points[v - half], points[v])) {
            const std::size_t from = places[v - half];
            const std::size_t end = text.find(' ', text.find(' ', from) + 1) + 1;
            text.append(text, from, end - from);
        } else {
            append_number(text, points[v].x());
            text += ' ';
            append_number(text, points[v].y());
            text += ' ';
        }
        append_number(text, points[v].z());
        text += ")\n";
    }
    return text + ")\n";
}

std::string encode_faces(const FoamCase& foam) {
    const Faces& faces = foam.mesh.faces;
    std::string text = foam_header("faceList", kMeshFolder, "faces") +
                       count_line(static_cast<std::size_t>(faces.n_faces()));
    for (int f = 0; f < faces.n_faces(); ++f) {
        checkpoint_each(f);
        append_number(text, faces.size(f));
        char before = '(';
        for (const int v : faces[f]) {
            text += before;
            append_number(text, v);
            before = ' ';
        }
        text += ")\n";
    }
    return text + ")\n";
}

void append_labels(std::string& text, const std::vector<int>& labels) {
    text += count_line(labels.size());
    for (const int label : labels) {
        append_number(text, label);
        text += '\n';
    }
    text += ")\n";
}

std::string encode_labels(const FiniteVolumeMesh& mesh, const std::string& name,
                          const std::vector<int>& cells) {
    std::string text = foam_header("labelList", kMeshFolder, name,
                                   "nPoints:" + std::to_string(mesh.n_points()) +
                                       " nCells:" + std::to_string(mesh.n_cells) +
                                       " nFaces:" + std::to_string(mesh.n_faces()) +
                                       " nInternalFaces:" + std::to_string(mesh.n_inner_faces()));
    append_labels(text, cells);
    return text;
}

std::string encode_owner(const FoamCase& foam) {
    return encode_labels(foam.mesh, "owner", foam.mesh.owner);
}

std::string encode_neighbour(const FoamCase& foam) {
    return encode_labels(foam.mesh, "neighbour", foam.mesh.neighbour);
}

void append_patch(std::string& text, const FiniteVolumeMesh& mesh, const FiniteVolumePatch& patch) {
    text += "    " + patch.name + "\n    {\n        type            " + foam_word(patch.kind) +
            ";\n        nFaces          " + std::to_string(patch.n_faces) +
            ";\n        startFace       " + std::to_string(patch.first_face) + ";\n";
    if (patch.kind == PatchKind::kCyclic) {
        text +=
            "        matchTolerance  1e-06;\n        transform       translational;\n"
            "        neighbourPatch  " +
            mesh.patches[patch.partner].name + ";\n        separationVector ";
        append_foam_vector(text, patch.separation);
        text += ";\n";
    }
    text += "    }\n";
}

std::string encode_boundary(const FoamCase& foam) {
    const std::vector<FiniteVolumePatch>& patches = foam.mesh.patches;
    std::string text = foam_header("polyBoundaryMesh", kMeshFolder, "boundary") + foam.notes +
                       count_line(patches.size());
    for (const FiniteVolumePatch& patch : patches) append_patch(text, foam.mesh, patch);
    return text + ")\n";
}

std::string encode_zones(const FoamCase& foam) {
    std::string text =
        foam_header("regIOobject", kMeshFolder, "cellZones") + count_line(foam.zones.size());
    for (const FoamZone& zone : foam.zones) {
        text += zone.name + "\n{\n    type            cellZone;\n    cellLabels      List<label>\n";
        append_labels(text, zone.cells);
        text += ";\n}\n";
    }
    return text + ")\n";
}

/// ParaView and VTK open a case by an empty file NAME.foam in its folder.
std::string encode_marker(const FoamCase&) { return ""; }

/// A file of a case; the name "" is that of the folder.
struct FoamFile {
    const char* name;
    std::string (*encode)(const FoamCase& foam);
    bool is_of_layers = false;
};

constexpr FoamFile kFoamFiles[] = {{"constant/polyMesh/points", encode_points},
                                   {"constant/polyMesh/faces", encode_faces},
                                   {"constant/polyMesh/owner", encode_owner},
                                   {"constant/polyMesh/neighbour", encode_neighbour},
                                   {"constant/polyMesh/boundary", encode_boundary},
                                   {"constant/polyMesh/cellZones", encode_zones},
                                   {"constant/transportProperties", foam_transport},
                                   {"constant/turbulenceProperties", foam_turbulence},
                                   {"system/controlDict", foam_control},
                                   {"system/fvSchemes", foam_schemes},
                                   {"system/fvSolution", foam_solution},
                                   {"0/U", foam_velocity},
                                   {"0/p", foam_pressure},
                                   {"0/T", foam_tracer, true},
                                   {"", encode_marker}};

/// Calls visit(file, path) for the files of a case.
template <class Visit>
void visit_files(const std::string& folder, FoamCells cells, const Visit& visit) {
    const std::string marker = std::filesystem::path(folder).filename().string();
    for (const FoamFile& file : kFoamFiles) {
        if (file.is_of_layers && cells != FoamCells::kLayer) continue;
        visit(file, folder + "/" + (*file.name == '\0' ? marker : file.name));
    }
}

}  // namespace

std::vector<std::string> foam_paths(const std::string& folder, FoamCells cells) {
    std::vector<std::string> paths;
    visit_files(folder, cells,
                [&](const FoamFile&, const std::string& path) { paths.push_back(path); });
    return paths;
}

std::vector<EncodedFile> encode_foam(const FoamCase& foam, const std::string& folder) {
    std::vector<EncodedFile> files;
    visit_files(folder, foam.cells, [&](const FoamFile& file, const std::string& path) {
        files.push_back({path, file.encode(foam)});
    });
    return files;
}

}  // namespace pcvt
