#include "io/solvers/vtu_writer.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "io/bytes/vtk_text.hpp"
#include "io/elements/solver_nodes.hpp"
#include "io/elements/triangle_elements.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/site_notes.hpp"

namespace pcvt {
namespace {

/// Appends an array of the whole grid with two numbers a tuple.
void append_vectors(std::string& text, const char* name, const std::vector<plane::Vec2>& vectors) {
    open_vtk_array(
        text, "Float64", name,
        " NumberOfTuples=\"" + std::to_string(vectors.size()) + "\" NumberOfComponents=\"2\"");
    for (const plane::Vec2& vector : vectors) {
        append_vtk_word(text, vector.x());
        append_vtk_word(text, vector.y());
        end_vtk_line(text);
    }
    close_vtk_array(text);
}

/// Appends a note as an array: of each site a tuple, of the tile the numbers in one line.
void append_note(std::string& text, const StatedNote& stated) {
    const SiteNote& note = *stated.note;
    const std::size_t width = note.of_each_site ? note.n_parts : 1;
    std::string attributes =
        " NumberOfTuples=\"" + std::to_string(stated.numbers.size() / width) + '"';
    if (width > 1) attributes += " NumberOfComponents=\"" + std::to_string(width) + '"';
    open_vtk_array(text, note.of_integers ? "Int32" : "Float64", note.array.data(), attributes);
    const std::size_t in_line = note.n_parts;
    for (std::size_t k = 0; k < stated.numbers.size(); ++k) {
        append_vtk_word(text, stated.numbers[k]);
        if ((k + 1) % in_line == 0) end_vtk_line(text);
    }
    close_vtk_array(text);
}

/// Appends strings as numbers: the codes of their characters, each string ended by 0. VTK's own
/// String arrays hold the same numbers, but meshio reads no file with such an array.
void append_strings(std::string& text, const char* name, const std::vector<std::string>& strings) {
    std::size_t n_codes = 0;
    for (const std::string& string : strings) n_codes += string.size() + 1;
    open_vtk_array(text, "UInt8", name, " NumberOfTuples=\"" + std::to_string(n_codes) + '"');
    for (const std::string& string : strings) {
        for (const char c : string) append_vtk_word(text, int{c});
        append_vtk_word(text, 0);
        end_vtk_line(text);
    }
    close_vtk_array(text);
}

void append_site_phases(std::string& text, const std::vector<int>& phases) {
    open_vtk_array(text, "Int32", "SitePhases",
                   " NumberOfTuples=\"" + std::to_string(phases.size()) + '"');
    for (const int phase : phases) {
        append_vtk_word(text, phase);
        end_vtk_line(text);
    }
    close_vtk_array(text);
}

/// Appends the names of holes, and the hole and the two points of each edge on one.
void append_holes(std::string& text, const plane::Tile& tile) {
    if (tile.holes.empty()) return;
    append_strings(text, "HoleNames", tile.holes);
    const auto n = std::count_if(tile.wall_edges.begin(), tile.wall_edges.end(),
                                 [](const plane::WallEdge& edge) { return edge.wall.is_hole(); });
    open_vtk_array(text, "Int32", "HoleEdges",
                   " NumberOfTuples=\"" + std::to_string(n) + "\" NumberOfComponents=\"3\"");
    for (const auto& [wall, v, w] : tile.wall_edges) {
        if (!wall.is_hole()) continue;
        for (const int number : {wall.hole(), v, w}) append_vtk_word(text, number);
        end_vtk_line(text);
    }
    close_vtk_array(text);
}

void append_field_data(std::string& text, const plane::Tile& tile, const CellMaterials& materials) {
    text += "<FieldData>\n";
    if (!materials.site_phase.empty()) {
        append_strings(text, "PhaseNames", materials.phase_names);
        append_site_phases(text, materials.site_phase);
    }
    append_vectors(text, "PeriodicLattice", {tile.lattice.a(), tile.lattice.b()});
    for (const StatedNote& stated : stated_notes(tile, true)) append_note(text, stated);
    append_holes(text, tile);
    text += "</FieldData>\n";
}

void append_point_data(std::string& text, const plane::Tile& tile, const SolverNodes& nodes) {
    // A node without a pair represents its own orbit.
    std::vector<int> ids(nodes.points.size());
    std::iota(ids.begin(), ids.end(), 0);
    std::vector<int> orbits = ids;
    std::vector<plane::Offset> offsets(nodes.points.size());
    for (const plane::VertexPair& pair : nodes.pairs) {
        orbits[pair.w] = pair.v;
        offsets[pair.w] = pair.offset;
    }
    // Ids and offsets.
    text += "<PointData GlobalIds=\"GlobalIds\">\n";
    append_vtk_integers(text, "Int64", "GlobalIds", ids);
    append_vtk_integers(text, "Int64", "PeriodicPointIds", orbits);
    open_vtk_array(text, "Int32", "PeriodicOffset", " NumberOfComponents=\"2\"");
    for (const plane::Offset& offset : offsets) {
        append_vtk_word(text, offset.i);
        append_vtk_word(text, offset.j);
        end_vtk_line(text);
    }
    close_vtk_array(text);
    // Sites of vertices; midside nodes have none.
    if (!tile.vertex_site.empty()) {
        std::vector<SiteId> sites = tile.vertex_site;
        sites.resize(nodes.points.size(), -1);
        append_vtk_integers(text, "Int32", "CellId", sites);
    }
    text += "</PointData>\n";
}

void append_points(std::string& text, const std::vector<plane::Vec2>& points) {
    text += "<Points>\n";
    open_vtk_array(text, "Float64", "Points", " NumberOfComponents=\"3\"");
    for (const plane::Vec2& p : points) {
        append_vtk_word(text, p.x());
        append_vtk_word(text, p.y());
        append_vtk_word(text, 0);
        end_vtk_line(text);
    }
    close_vtk_array(text);
    text += "</Points>\n";
}

int vtk_type(const plane::Tile& tile) {
    if (tile.kind == plane::MeshKind::kVoronoi) return kVtkPolygon;
    return tile.order == 2 ? kVtkQuadraticTriangle : kVtkTriangle;
}

void append_cells(std::string& text, const plane::Tile& tile, const SolverNodes& nodes) {
    std::vector<int> ends;
    int end = 0;
    text += "<Cells>\n";
    open_vtk_array(text, "Int64", "connectivity");
    for (int f = 0; f < tile.n_faces(); ++f) {
        for (const int v : element_nodes(tile, nodes, f)) {
            append_vtk_word(text, v);
            ++end;
        }
        end_vtk_line(text);
        ends.push_back(end);
    }
    close_vtk_array(text);
    append_vtk_integers(text, "Int64", "offsets", ends);
    append_vtk_integers(text, "UInt8", "types",
                        std::vector<int>(static_cast<std::size_t>(tile.n_faces()), vtk_type(tile)));
    text += "</Cells>\n";
}

/// Appends a number of each site as that of its elements.
void append_numbers_of_sites(std::string& text, const char* name, std::vector<int> cells,
                             std::span<const int> of_site) {
    if (of_site.empty()) return;
    // Of a file under proof, the numbers are those of its own cells.
    const auto is_known = [&](int cell) { return std::cmp_less(cell, of_site.size()); };
    for (int& cell : cells) cell = is_known(cell) ? of_site[cell] : -1;
    append_vtk_integers(text, "Int32", name, cells);
}

void append_cell_data(std::string& text, const plane::Tile& tile, std::span<const int> site_orbits,
                      const CellMaterials& materials) {
    const std::vector<int> cells = element_cells(tile);
    text += "<CellData>\n";
    append_vtk_integers(text, "Int32", "CellId", cells);
    append_numbers_of_sites(text, "Orbit", cells, site_orbits);
    append_numbers_of_sites(text, "Phase", cells, materials.site_phase);
    text += "</CellData>\n";
}

}  // namespace

std::vector<EncodedFile> encode_vtu(const plane::Tile& tile, const std::string& path,
                                    std::span<const int> site_orbits,
                                    const CellMaterials& materials) {
    require_finite(tile);
    const SolverNodes nodes = solver_nodes(tile);
    std::string text =
        "<?xml version=\"1.0\"?>\n<!-- A periodic tile, written by pcvt -->\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<UnstructuredGrid>\n";
    append_field_data(text, tile, materials);
    text += "<Piece NumberOfPoints=\"" + std::to_string(nodes.n_nodes()) + "\" NumberOfCells=\"" +
            std::to_string(tile.n_faces()) + "\">\n";
    append_point_data(text, tile, nodes);
    append_cell_data(text, tile, site_orbits, materials);
    append_points(text, nodes.points);
    append_cells(text, tile, nodes);
    text += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return only_file(path, std::move(text));
}

}  // namespace pcvt
