#include "io/openfoam/foam_writer.hpp"

#include <cmath>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/openfoam/foam_case.hpp"
#include "io/openfoam/foam_text.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/raw_tile.hpp"

namespace pcvt {
namespace {

const char* const kMeshFolder = "constant/polyMesh";

std::string count_line(int n) { return std::to_string(n) + "\n(\n"; }

std::string encode_points(const SlabMesh& slab) {
    std::string text =
        foam_header("vectorField", kMeshFolder, "points") + count_line(slab.n_points());
    // The front repeats the back at another z.
    std::string place;
    std::vector<std::string::size_type> begin{0};
    for (int v = 0; v < slab.n_points() / 2; ++v) {
        place += '(';
        append_number(place, slab.points[v].x());
        place += ' ';
        append_number(place, slab.points[v].y());
        place += ' ';
        begin.push_back(place.size());
    }
    for (const double z : {slab.points.front().z(), slab.points.back().z()}) {
        std::string end;
        append_number(end, z);
        end += ")\n";
        for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
            text.append(place, begin[v], begin[v + 1] - begin[v]).append(end);
        }
    }
    return text + ")\n";
}

std::string encode_faces(const SlabMesh& slab) {
    std::string text = foam_header("faceList", kMeshFolder, "faces") + count_line(slab.n_faces());
    for (int f = 0; f < slab.n_faces(); ++f) {
        append_number(text, slab.face_size(f));
        char before = '(';
        for (int c = slab.face_begin[f]; c < slab.face_begin[f + 1]; ++c) {
            text += before;
            append_number(text, slab.corners[c]);
            before = ' ';
        }
        text += ")\n";
    }
    return text + ")\n";
}

std::string encode_labels(const SlabMesh& slab, const std::string& name,
                          const std::vector<int>& cells) {
    const std::string note = "nPoints:" + std::to_string(slab.n_points()) +
                             " nCells:" + std::to_string(slab.patches.back().n_faces) +
                             " nFaces:" + std::to_string(slab.n_faces()) +
                             " nInternalFaces:" + std::to_string(slab.n_inner_faces());
    std::string text = foam_header("labelList", kMeshFolder, name, note) +
                       count_line(static_cast<int>(cells.size()));
    for (const int cell : cells) {
        append_number(text, cell);
        text += '\n';
    }
    return text + ")\n";
}

void append_patch(std::string& text, const SlabMesh& slab, const SlabPatch& patch) {
    text += "    " + patch.name + "\n    {\n        type            " +
            (patch.partner < 0 ? "empty" : "cyclic") + ";\n        nFaces          " +
            std::to_string(patch.n_faces) + ";\n        startFace       " +
            std::to_string(patch.first_face) + ";\n";
    if (patch.partner >= 0) {
        text +=
            "        matchTolerance  1e-06;\n        transform       translational;\n"
            "        neighbourPatch  " +
            slab.patches[patch.partner].name + ";\n        separationVector ";
        append_foam_vector(text, {patch.separation.x(), patch.separation.y(), 0});
        text += ";\n";
    }
    text += "    }\n";
}

std::string encode_boundary(const SlabMesh& slab) {
    std::string text = foam_header("polyBoundaryMesh", kMeshFolder, "boundary") +
                       "// A periodic tile, written by pcvt: seam_I_J is answered at + I a + J b\n"
                       "// pcvt kind " +
                       kind_word(slab.kind) + "\n// pcvt lattice";
    const Vec2& a = slab.lattice.a();
    const Vec2& b = slab.lattice.b();
    for (const double number : {a.x(), a.y(), b.x(), b.y()}) {
        text += ' ';
        append_number(text, number);
    }
    text += "\n" + count_line(static_cast<int>(slab.patches.size()));
    for (const SlabPatch& patch : slab.patches) append_patch(text, slab, patch);
    return text + ")\n";
}

}  // namespace

std::vector<std::string> foam_paths(const std::string& folder) {
    std::vector<std::string> paths;
    for (const char* name :
         {"constant/polyMesh/points", "constant/polyMesh/faces", "constant/polyMesh/owner",
          "constant/polyMesh/neighbour", "constant/polyMesh/boundary",
          "constant/transportProperties", "system/controlDict", "system/fvSchemes",
          "system/fvSolution", "0/U", "0/p"}) {
        paths.push_back(folder + "/" + name);
    }
    return paths;
}

std::vector<EncodedFile> encode_foam(const FlatTile& tile, const std::string& folder) {
    require_finite(tile);
    const SlabMesh slab = slab_mesh(tile);
    const DecayingFlow flow(tile.lattice);
    std::vector<std::string> contents = {
        encode_points(slab),
        encode_faces(slab),
        encode_labels(slab, "owner", slab.owner),
        encode_labels(slab, "neighbour", slab.neighbour),
        encode_boundary(slab),
        foam_transport(flow),
        foam_control(flow, std::sqrt(tile.lattice.area() / tile.n_faces())),
        foam_schemes(),
        foam_solution(),
        foam_velocity(flow, slab, tile),
        foam_pressure(slab)};
    const std::vector<std::string> paths = foam_paths(folder);
    std::vector<EncodedFile> files;
    for (std::size_t k = 0; k < paths.size(); ++k) {
        files.push_back({paths[k], std::move(contents[k])});
    }
    return files;
}

}  // namespace pcvt
