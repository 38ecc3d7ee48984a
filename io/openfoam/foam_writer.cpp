#include "io/openfoam/foam_writer.hpp"

#include <filesystem>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/openfoam/foam_case.hpp"
#include "io/openfoam/foam_text.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/material_words.hpp"
#include "io/tiles/site_notes.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kSitesALine = 16;

/// ParaView and VTK open a case by an empty file NAME.foam in its folder.
const char* const kMarker = "";

std::string count_line(int n) { return std::to_string(n) + "\n(\n"; }

std::string encode_points(const ExtrudedMesh& extruded) {
    std::string text =
        foam_header("vectorField", kMeshFolder, "points") + count_line(extruded.n_points());
    // Write x and y once: the front repeats the back at another z.
    std::string place;
    std::vector<std::string::size_type> begin{0};
    for (int v = 0; v < extruded.n_points() / 2; ++v) {
        place += '(';
        append_number(place, extruded.points[v].x());
        place += ' ';
        append_number(place, extruded.points[v].y());
        place += ' ';
        begin.push_back(place.size());
    }
    // Complete them with the z of the back and of the front.
    for (const double z : {extruded.points.front().z(), extruded.points.back().z()}) {
        std::string end;
        append_number(end, z);
        end += ")\n";
        for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
            text.append(place, begin[v], begin[v + 1] - begin[v]).append(end);
        }
    }
    return text + ")\n";
}

std::string encode_faces(const ExtrudedMesh& extruded) {
    std::string text =
        foam_header("faceList", kMeshFolder, "faces") + count_line(extruded.n_faces());
    for (int f = 0; f < extruded.n_faces(); ++f) {
        append_number(text, extruded.face_size(f));
        char before = '(';
        for (const int v : extruded.faces[f]) {
            text += before;
            append_number(text, v);
            before = ' ';
        }
        text += ")\n";
    }
    return text + ")\n";
}

std::string encode_labels(const ExtrudedMesh& extruded, const std::string& name,
                          const std::vector<int>& cells) {
    const std::string note = "nPoints:" + std::to_string(extruded.n_points()) +
                             " nCells:" + std::to_string(extruded.patches.back().n_faces) +
                             " nFaces:" + std::to_string(extruded.n_faces()) +
                             " nInternalFaces:" + std::to_string(extruded.n_inner_faces());
    std::string text = foam_header("labelList", kMeshFolder, name, note) +
                       count_line(static_cast<int>(cells.size()));
    for (const int cell : cells) {
        append_number(text, cell);
        text += '\n';
    }
    return text + ")\n";
}

void append_patch(std::string& text, const ExtrudedMesh& extruded, const ExtrudedPatch& patch) {
    text += "    " + patch.name + "\n    {\n        type            " +
            (patch.wall          ? "wall"
             : patch.partner < 0 ? "empty"
                                 : "cyclic") +
            ";\n        nFaces          " + std::to_string(patch.n_faces) +
            ";\n        startFace       " + std::to_string(patch.first_face) + ";\n";
    if (patch.partner >= 0) {
        text +=
            "        matchTolerance  1e-06;\n        transform       translational;\n"
            "        neighbourPatch  " +
            extruded.patches[patch.partner].name + ";\n        separationVector ";
        append_foam_vector(text, {patch.separation.x(), patch.separation.y(), 0});
        text += ";\n";
    }
    text += "    }\n";
}

/// Appends the site of each cell, or of each point of Delaunay triangles, as comments.
void append_sites(std::string& text, const plane::Tile& tile) {
    const std::vector<SiteId>& sites = tile.sites();
    for (std::size_t k = 0; k < sites.size(); ++k) {
        text += k % kSitesALine == 0 ? (k == 0 ? "// pcvt sites" : "\n// pcvt sites") : "";
        text += ' ';
        append_number(text, sites[k]);
    }
    if (!sites.empty()) text += '\n';
}

/// The phases of the cells alone, which are all that a case states of materials.
CellMaterials held_phases(const CellMaterials* materials) {
    if (materials == nullptr) return {};
    return {.phase_names = materials->phase_names, .site_phase = materials->site_phase};
}

/// Returns the zones of the cells, one for each phase.
std::string encode_zones(const plane::Tile& tile, const CellMaterials& materials) {
    std::vector<std::vector<int>> zones(materials.phase_names.size());
    if (!zones.empty()) {
        for (int f = 0; f < tile.n_faces(); ++f) {
            zones[materials.site_phase[tile.face_site[f]]].push_back(f);
        }
    }
    std::string text = foam_header("regIOobject", kMeshFolder, "cellZones") +
                       count_line(static_cast<int>(zones.size()));
    for (std::size_t p = 0; p < zones.size(); ++p) {
        text += phase_group(materials.phase_names[p]) +
                "\n{\n    type            cellZone;\n    cellLabels      List<label>\n" +
                count_line(static_cast<int>(zones[p].size()));
        for (const int cell : zones[p]) {
            append_number(text, cell);
            text += '\n';
        }
        text += ")\n;\n}\n";
    }
    return text + ")\n";
}

std::string encode_boundary(const plane::Tile& tile, const ExtrudedMesh& extruded,
                            const CellMaterials& materials) {
    std::string text = foam_header("polyBoundaryMesh", kMeshFolder, "boundary") +
                       "// A periodic tile, written by pcvt: seam_I_J is answered at + I a + J b\n"
                       "// pcvt kind " +
                       file_word(extruded.kind) + "\n// pcvt lattice";
    const plane::Vec2& a = extruded.lattice.a();
    const plane::Vec2& b = extruded.lattice.b();
    for (const double number : {a.x(), a.y(), b.x(), b.y()}) {
        text += ' ';
        append_number(text, number);
    }
    text += '\n';
    append_note_comments(text, "// pcvt ", tile, 0);
    append_sites(text, tile);
    append_materials(text, "// pcvt ", materials);
    text += count_line(static_cast<int>(extruded.patches.size()));
    for (const ExtrudedPatch& patch : extruded.patches) append_patch(text, extruded, patch);
    return text + ")\n";
}

}  // namespace

std::vector<std::string> foam_paths(const std::string& folder) {
    std::vector<std::string> paths;
    for (const char* name :
         {"constant/polyMesh/points", "constant/polyMesh/faces", "constant/polyMesh/owner",
          "constant/polyMesh/neighbour", "constant/polyMesh/boundary",
          "constant/polyMesh/cellZones", "constant/transportProperties",
          "constant/turbulenceProperties", "system/controlDict", "system/fvSchemes",
          "system/fvSolution", "0/U", "0/p", "0/T"}) {
        paths.push_back(folder + "/" + name);
    }
    paths.push_back(folder + "/" + std::filesystem::path(folder).filename().string());
    return paths;
}

std::vector<EncodedFile> encode_foam(const plane::Tile& tile, const std::string& folder,
                                     double thickness, const CellMaterials* materials) {
    require_finite(tile);
    const ExtrudedMesh extruded = extruded_mesh(tile, thickness);
    const DecayingFlow flow(tile.lattice, tile.walls);
    const CellFlow cells = cell_flow(flow, tile, extruded);
    const CellMaterials phases = held_phases(materials);
    // The contents have the order of foam_paths().
    std::vector<std::string> contents = {encode_points(extruded),
                                         encode_faces(extruded),
                                         encode_labels(extruded, "owner", extruded.owner),
                                         encode_labels(extruded, "neighbour", extruded.neighbour),
                                         encode_boundary(tile, extruded, phases),
                                         encode_zones(tile, phases),
                                         foam_transport(flow, cells),
                                         foam_turbulence(),
                                         foam_control(flow.turn_time(), cells.courant_rate),
                                         foam_schemes(),
                                         foam_solution(),
                                         foam_velocity(cells, extruded),
                                         foam_pressure(extruded),
                                         foam_tracer(cells, extruded),
                                         kMarker};
    const std::vector<std::string> paths = foam_paths(folder);
    std::vector<EncodedFile> files;
    for (std::size_t k = 0; k < paths.size(); ++k) {
        files.push_back({paths[k], std::move(contents[k])});
    }
    return files;
}

}  // namespace pcvt
