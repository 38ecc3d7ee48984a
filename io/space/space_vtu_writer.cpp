#include "io/space/space_vtu_writer.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "io/bytes/vtk_text.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/polyhedra/cell_faces.hpp"

namespace pcvt {
namespace {

constexpr int kVtkPolyhedron = 42;

void append_vector(std::string& text, const Vec3& vector) {
    for (const double x : vector) append_vtk_word(text, x);
    end_vtk_line(text);
}

void append_field_data(std::string& text, const SpaceLattice& lattice) {
    text += "<FieldData>\n";
    open_vtk_array(text, "Float64", "PeriodicLattice",
                   " NumberOfTuples=\"3\" NumberOfComponents=\"3\"");
    for (const Vec3& period : lattice.periods()) append_vector(text, period);
    close_vtk_array(text);
    text += "</FieldData>\n";
}

void append_point_data(std::string& text, const PolyhedralMesh& mesh) {
    text += "<PointData>\n";
    append_vtk_integers(text, "Int64", "PeriodicPointIds", mesh.point_orbit);
    open_vtk_array(text, "Int32", "PeriodicOffset", " NumberOfComponents=\"3\"");
    for (const Offset3& offset : mesh.point_offset) {
        for (const int number : {offset.i, offset.j, offset.k}) append_vtk_word(text, number);
        end_vtk_line(text);
    }
    close_vtk_array(text);
    text += "</PointData>\n";
}

void append_cell_data(std::string& text, const SpaceTile& tile, const PolyhedronList& cells) {
    std::vector<int> ids(static_cast<std::size_t>(cells.n_cells()));
    std::iota(ids.begin(), ids.end(), 0);
    std::vector<int> n_faces;
    for (const int s : ids) n_faces.push_back(cells.cell_begin[s + 1] - cells.cell_begin[s]);
    text += "<CellData>\n";
    append_vtk_integers(text, "Int32", "CellId", ids);
    append_vtk_integers(text, "Int32", "Faces", n_faces);
    open_vtk_array(text, "Float64", "Volume");
    for (const CellBody& body : cell_bodies(tile.mesh)) {
        append_vtk_word(text, body.volume);
        end_vtk_line(text);
    }
    close_vtk_array(text);
    if (tile.sites.cols() > 0) {
        open_vtk_array(text, "Float64", "Site", " NumberOfComponents=\"3\"");
        for (const auto& site : tile.sites.colwise()) append_vector(text, site);
        close_vtk_array(text);
    }
    text += "</CellData>\n";
}

void append_points(std::string& text, const std::vector<Vec3>& points) {
    text += "<Points>\n";
    open_vtk_array(text, "Float64", "Points", " NumberOfComponents=\"3\"");
    for (const Vec3& p : points) append_vector(text, p);
    close_vtk_array(text);
    text += "</Points>\n";
}

/// Appends each cell as the number of its faces, and each face as the number of its points and
/// these. Returns the end of each cell in the array.
std::vector<int> append_faces(std::string& text, const PolyhedronList& cells) {
    std::vector<int> ends;
    int end = 0;
    open_vtk_array(text, "Int64", "faces");
    for (int s = 0; s < cells.n_cells(); ++s) {
        checkpoint_each(s);
        append_vtk_word(text, cells.cell_begin[s + 1] - cells.cell_begin[s]);
        ++end;
        for (int f = cells.cell_begin[s]; f < cells.cell_begin[s + 1]; ++f) {
            append_vtk_word(text, cells.faces.size(f));
            for (const int v : cells.faces[f]) append_vtk_word(text, v);
            end += 1 + cells.faces.size(f);
        }
        end_vtk_line(text);
        ends.push_back(end);
    }
    close_vtk_array(text);
    return ends;
}

void append_cells(std::string& text, const PolyhedronList& cells) {
    std::vector<int> ends;
    int end = 0;
    text += "<Cells>\n";
    open_vtk_array(text, "Int64", "connectivity");
    for (int s = 0; s < cells.n_cells(); ++s) {
        checkpoint_each(s);
        for (const int v : cell_points(cells, s)) {
            append_vtk_word(text, v);
            ++end;
        }
        end_vtk_line(text);
        ends.push_back(end);
    }
    close_vtk_array(text);
    append_vtk_integers(text, "Int64", "offsets", ends);
    append_vtk_integers(text, "UInt8", "types", std::vector<int>(ends.size(), kVtkPolyhedron));
    append_vtk_integers(text, "Int64", "faceoffsets", append_faces(text, cells));
    text += "</Cells>\n";
}

}  // namespace

std::vector<int> cell_points(const PolyhedronList& cells, int cell) {
    const auto begin = cells.faces.corners.begin();
    std::vector<int> points(begin + cells.faces.begin[cells.cell_begin[cell]],
                            begin + cells.faces.begin[cells.cell_begin[cell + 1]]);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

std::vector<EncodedFile> encode_space_vtu(const SpaceTile& tile, const std::string& path) {
    const PolyhedronList cells = polyhedron_list(tile.mesh);
    std::string text =
        "<?xml version=\"1.0\"?>\n" + std::string(kSpaceVtuMark) +
        "\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<UnstructuredGrid>\n";
    append_field_data(text, tile.mesh.lattice);
    text += "<Piece NumberOfPoints=\"" + std::to_string(tile.mesh.n_points()) +
            "\" NumberOfCells=\"" + std::to_string(cells.n_cells()) + "\">\n";
    append_point_data(text, tile.mesh);
    append_cell_data(text, tile, cells);
    append_points(text, tile.mesh.points);
    append_cells(text, cells);
    text += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return only_file(path, std::move(text));
}

}  // namespace pcvt
