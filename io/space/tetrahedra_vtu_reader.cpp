#include "io/space/tetrahedra_vtu_reader.hpp"

#include "io/bytes/bad_file.hpp"
#include "io/bytes/text.hpp"
#include "io/bytes/vtk_text.hpp"
#include "io/space/point_offsets.hpp"
#include "io/space/space_vtu_parts.hpp"
#include "io/space/space_vtu_reader.hpp"
#include "io/space/tetrahedra_vtu_writer.hpp"

namespace pcvt {
namespace {

[[noreturn]] void fail_at(const std::string& name, int line, const std::string& complaint) {
    throw BadFile(name + ":" + std::to_string(line) + ": " + complaint);
}

/// Entry k of an array, which must be from 0 to n - 1.
int index(const std::string& name, const VtuArray& array, std::size_t k, int n) {
    const int number = array.integer(k);
    if (number < 0 || number >= n) {
        fail_at(name, array.lines[k],
                std::to_string(number) + " is not a number from 0 to " + std::to_string(n - 1) +
                    "; correct it");
    }
    return number;
}

void read_tetrahedra(const std::string& name, const VtuArrays& arrays,
                     space::TetrahedralMesh& mesh) {
    const int n = arrays.n_cells();
    const VtuArray& types = arrays.get("Cells/types", n, 1, true);
    const VtuArray& ends = arrays.get("Cells/offsets", n, 1, true);
    const VtuArray& corners = arrays.get("Cells/connectivity", -1, 1, true);
    for (int t = 0; t < n; ++t) {
        const auto k = static_cast<std::size_t>(t);
        if (types.integer(k) != kVtkTetra) {
            fail_at(name, types.lines[k], "a cell is no tetrahedron (type 10); leave it out");
        }
        if (ends.values[k] != 4.0 * (t + 1) || corners.size() < 4 * (k + 1)) {
            fail_at(name, ends.lines[k], "a tetrahedron has 4 points; give the whole file");
        }
        std::array<int, 4>& corner = mesh.tetrahedra.emplace_back();
        for (std::size_t i = 0; i < 4; ++i) {
            corner[i] = index(name, corners, 4 * k + i, mesh.n_points());
        }
    }
    if (corners.size() != 4 * mesh.tetrahedra.size()) {
        fail_at(name, corners.line, "the array goes on after the last cell");
    }
}

}  // namespace

bool holds_vtu_tetrahedra(const EncodedFile& vtu) {
    const std::size_t at = vtu.bytes.find("Name=\"PeriodicLattice\"");
    if (at == std::string::npos || holds_polyhedra(vtu)) return false;
    const std::size_t begin = vtu.bytes.rfind('<', at);
    const std::size_t end = vtu.bytes.find('>', at);
    if (begin == std::string::npos || end == std::string::npos) return false;
    return std::string_view(vtu.bytes).substr(begin, end - begin).find("NumberOfTuples=\"3\"") !=
           std::string_view::npos;
}

space::TetrahedralMesh decode_tetrahedra_vtu(const EncodedFile& vtu) {
    refuse_binary(vtu.path, vtu.bytes, "export it as ASCII");
    const VtuArrays arrays(vtu.path, vtu.bytes);
    if (arrays.n_cells() == 0 || arrays.n_points() == 0) {
        throw BadFile(vtu.path + ": holds no tetrahedron; give the whole file");
    }
    space::TetrahedralMesh mesh{.lattice = read_space_lattice(vtu.path, arrays),
                                .points = read_space_points(vtu.path, arrays)};
    const VtuArray& sites = arrays.get("PointData/CellId", arrays.n_points(), 1, true);
    for (std::size_t v = 0; v < sites.size(); ++v) {
        mesh.point_site.push_back(index(vtu.path, sites, v, arrays.n_points()));
    }
    find_point_offsets(vtu.path, mesh);
    compare_images(vtu.path, arrays, first_points(mesh), mesh.point_offset);
    read_tetrahedra(vtu.path, arrays, mesh);
    return mesh;
}

void compare_tetrahedra_vtu(const EncodedFile& vtu, const space::TetrahedralMesh& mesh) {
    if (vtu.bytes.find(kTetrahedraVtuMark) == std::string::npos) return;
    require_same_bytes({vtu}, encode_tetrahedra_vtu(mesh, vtu.path));
}

}  // namespace pcvt
