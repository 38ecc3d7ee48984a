#include "io/space/space_vtu_writer.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "io/bytes/vtk_text.hpp"
#include "io/space/space_vtu_parts.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/space/mesh/cell_faces.hpp"

namespace pcvt {
namespace {

void append_cell_data(std::string& text, const SpaceTile& tile,
                      const space::PolyhedronList& cells) {
    std::vector<int> ids(static_cast<std::size_t>(cells.n_cells()));
    std::iota(ids.begin(), ids.end(), 0);
    std::vector<int> n_faces;
    for (const int s : ids) n_faces.push_back(cells.cell_begin[s + 1] - cells.cell_begin[s]);
    text += "<CellData>\n";
    append_vtk_integers(text, "Int32", "CellId", ids);
    append_vtk_integers(text, "Int32", "Faces", n_faces);
    open_vtk_array(text, "Float64", "Volume");
    for (const space::CellBody& body : cell_bodies(tile.mesh)) {
        append_vtk_word(text, body.volume);
        end_vtk_line(text);
    }
    close_vtk_array(text);
    if (tile.sites.cols() > 0) {
        open_vtk_array(text, "Float64", "Site", " NumberOfComponents=\"3\"");
        for (const auto& site : tile.sites.colwise()) append_space_vector(text, site);
        close_vtk_array(text);
    }
    text += "</CellData>\n";
}

/// Appends each cell as the number of its faces, and each face as the number of its points and
/// these. Returns the end of each cell in the array.
std::vector<int> append_faces(std::string& text, const space::PolyhedronList& cells) {
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

void append_cells(std::string& text, const space::PolyhedronList& cells) {
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

std::vector<int> cell_points(const space::PolyhedronList& cells, int cell) {
    const auto begin = cells.faces.corners.begin();
    std::vector<int> points(begin + cells.faces.begin[cells.cell_begin[cell]],
                            begin + cells.faces.begin[cells.cell_begin[cell + 1]]);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

std::vector<EncodedFile> encode_space_vtu(const SpaceTile& tile, const std::string& path) {
    const space::PolyhedronList cells = polyhedron_list(tile.mesh);
    std::string text;
    open_space_vtu(text, kSpaceVtuMark, tile.mesh.lattice, tile.mesh.short_edges,
                   tile.mesh.n_points(), cells.n_cells());
    text += "<PointData>\n";
    append_images(text, tile.mesh.point_orbit, tile.mesh.point_offset);
    text += "</PointData>\n";
    append_cell_data(text, tile, cells);
    append_space_points(text, tile.mesh.points);
    append_cells(text, cells);
    text += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return only_file(path, std::move(text));
}

}  // namespace pcvt
