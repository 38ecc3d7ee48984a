#include "io/space/tetrahedra_vtu_writer.hpp"

#include <utility>

#include "io/bytes/vtk_text.hpp"
#include "io/space/point_offsets.hpp"
#include "io/space/space_vtu_parts.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

void append_cells(std::string& text, const space::TetrahedralMesh& mesh) {
    std::vector<int> ends;
    text += "<Cells>\n";
    open_vtk_array(text, "Int64", "connectivity");
    for (const std::array<int, 4>& corners : mesh.tetrahedra) {
        checkpoint_each(static_cast<int>(ends.size()));
        for (const int v : corners) append_vtk_word(text, v);
        end_vtk_line(text);
        ends.push_back(4 * static_cast<int>(ends.size() + 1));
    }
    close_vtk_array(text);
    append_vtk_integers(text, "Int64", "offsets", ends);
    append_vtk_integers(text, "UInt8", "types", std::vector<int>(ends.size(), kVtkTetra));
    text += "</Cells>\n";
}

}  // namespace

std::vector<EncodedFile> encode_tetrahedra_vtu(const space::TetrahedralMesh& mesh,
                                               const std::string& path) {
    std::string text;
    open_space_vtu(text, kTetrahedraVtuMark, mesh.lattice, 0, mesh.n_points(), mesh.n_tetrahedra());
    text += "<PointData>\n";
    append_images(text, first_points(mesh), mesh.point_offset);
    append_vtk_integers(text, "Int32", "CellId", mesh.point_site);
    text += "</PointData>\n";
    append_space_points(text, mesh.points);
    append_cells(text, mesh);
    text += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    return only_file(path, std::move(text));
}

}  // namespace pcvt
