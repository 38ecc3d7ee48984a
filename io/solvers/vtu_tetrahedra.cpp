#include "io/solvers/vtu_tetrahedra.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/bytes/text.hpp"
#include "io/forms/point_offsets.hpp"
#include "io/solvers/vtu_space.hpp"
#include "io/solvers/vtu_volumes.hpp"
#include "io/solvers/vtu_writer.hpp"

namespace pcvt {
namespace {

/// Compares the images that a file states for its nodes with those of a mesh in space.
void compare_images(const VtuArrays& arrays, const ElementMesh& mesh) {
    std::vector<space::Offset> offsets;
    for (std::size_t k = 0; k < mesh.offsets.size(); k += 3) {
        offsets.push_back({mesh.offsets[k], mesh.offsets[k + 1], mesh.offsets[k + 2]});
    }
    StatedImages(arrays).compare(mesh.orbit, offsets);
}

/// Requires numbers from `least` to n - 1.
void require_numbers(const VtuArrays& arrays, const VtuArray& numbers, int n, int least = 0) {
    for (std::size_t v = 0; v < numbers.size(); ++v) {
        const int number = numbers.integer(v);
        if (number >= least && number < n) continue;
        arrays.scanner().throw_bad_file(numbers.lines[v],
                                        std::to_string(number) + " is not a number from 0 to " +
                                            std::to_string(n - 1) + "; correct it");
    }
}

/// Reads the sites of points or, of tetrahedra inside of cells, those of the cells, and numbers the
/// nodes by the orbits of points.
void read_point_sites(const VtuArrays& arrays, space::TetrahedralMesh& mesh) {
    const int n = mesh.n_points();
    if (arrays.find("CellData/CellId") == nullptr) {
        // Nodes in the middle of edges have no site.
        const VtuArray& sites = arrays.get("PointData/CellId", n, 1, true);
        require_numbers(arrays, sites, n, -1);
        for (std::size_t v = 0; v < sites.size(); ++v) mesh.point_site.push_back(sites.integer(v));
        return;
    }
    const VtuArray& cells = arrays.get("CellData/CellId", arrays.n_cells(), 1, true);
    require_numbers(arrays, cells, arrays.n_cells());
    for (std::size_t t = 0; t < cells.size(); ++t) mesh.cell.push_back(cells.integer(t));
    const VtuArray& orbits = arrays.get("PointData/PeriodicPointIds", n, 1, true);
    require_numbers(arrays, orbits, n);
    std::vector<int> numbers(mesh.points.size(), -1);
    int n_nodes = 0;
    for (std::size_t v = 0; v < orbits.size(); ++v) {
        int& number = numbers[orbits.integer(v)];
        if (number < 0) number = n_nodes++;
        mesh.point_site.push_back(number);
    }
}

}  // namespace

bool holds_vtu_tetrahedra(const EncodedFile& vtu) {
    const std::size_t at = vtu.bytes.find("Name=\"PeriodicLattice\"");
    if (at == std::string::npos || holds_vtu_polyhedra(vtu)) return false;
    const std::size_t begin = vtu.bytes.rfind('<', at);
    const std::size_t end = vtu.bytes.find('>', at);
    if (begin == std::string::npos || end == std::string::npos) return false;
    return std::string_view(vtu.bytes).substr(begin, end - begin).find("NumberOfTuples=\"3\"") !=
           std::string_view::npos;
}

TetrahedralTile decode_vtu_tetrahedra(const EncodedFile& vtu) {
    refuse_binary(vtu.path, vtu.bytes, "export it as ASCII");
    const VtuArrays arrays(vtu.path, vtu.bytes, std::array{kOrientationArray});
    const int n = arrays.n_points();
    if (arrays.n_cells() == 0 || n == 0) {
        throw BadFile(vtu.path + ": holds no tetrahedron; give the whole file");
    }
    TetrahedralTile tile{.mesh = {.lattice = read_vtu_lattice<space::Lattice>(arrays),
                                  .points = read_vtu_points(arrays)}};
    space::TetrahedralMesh& mesh = tile.mesh;
    FileTetrahedra found{.name = vtu.path};
    found.elements =
        read_vtu_cells(arrays, {ElementKind::kTetrahedron4, ElementKind::kTetrahedron10});
    const VtuArray& corners = arrays.get("Cells/connectivity", -1, 1, true);
    for (int t = 0; t < found.elements.size(); ++t) {
        found.lines.push_back(corners.lines[found.elements.nodes.begin[t]]);
    }
    read_point_sites(arrays, mesh);
    place_tetrahedra(found, mesh);
    if (std::find(mesh.point_site.begin(), mesh.point_site.end(), -1) != mesh.point_site.end()) {
        throw BadFile(vtu.path + ": a point has no site; write the file again with pcvt");
    }
    find_point_offsets(vtu.path, mesh);
    compare_images(arrays, element_mesh(mesh));
    require_sorted_cells(vtu.path, mesh);
    tile.materials = read_vtu_materials(arrays, mesh.cell);
    return tile;
}

void compare_vtu_tetrahedra(const EncodedFile& vtu, const TetrahedralTile& tile) {
    if (vtu.bytes.find(kTetrahedraVtuMark) == std::string::npos) return;
    require_same_bytes({vtu}, encode_vtu(vtu_grid(tile.mesh, &tile.materials), vtu.path));
}

}  // namespace pcvt
