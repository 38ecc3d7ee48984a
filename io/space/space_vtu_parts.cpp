#include "io/space/space_vtu_parts.hpp"

#include <Eigen/Core>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/vtk_text.hpp"
#include "io/space/space_tile.hpp"
#include "mesher/base/error.hpp"
#include "mesher/space/mesh/short_edges.hpp"

namespace pcvt {
namespace {

[[noreturn]] void fail(const std::string& name, int line, const std::string& complaint) {
    throw BadFile(name + ":" + std::to_string(line) + ": " + complaint);
}

/// "(1, 0, -1)"
std::string in_words(const space::Offset& offset) {
    return "(" + std::to_string(offset.i) + ", " + std::to_string(offset.j) + ", " +
           std::to_string(offset.k) + ")";
}

}  // namespace

void open_space_vtu(std::string& text, std::string_view mark, const space::Lattice& lattice,
                    double short_edges, int n_points, int n_cells) {
    text += "<?xml version=\"1.0\"?>\n" + std::string(mark) +
            "\n"
            "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
            "<UnstructuredGrid>\n<FieldData>\n";
    open_vtk_array(text, "Float64", "PeriodicLattice",
                   " NumberOfTuples=\"3\" NumberOfComponents=\"3\"");
    for (const space::Vec3& period : lattice.periods()) append_space_vector(text, period);
    close_vtk_array(text);
    if (short_edges > 0) {
        open_vtk_array(text, "Float64", "ShortEdges", " NumberOfTuples=\"1\"");
        append_vtk_word(text, short_edges);
        end_vtk_line(text);
        close_vtk_array(text);
    }
    text += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(n_points) +
            "\" NumberOfCells=\"" + std::to_string(n_cells) + "\">\n";
}

void append_space_vector(std::string& text, const space::Vec3& vector) {
    for (const double x : vector) append_vtk_word(text, x);
    end_vtk_line(text);
}

void append_images(std::string& text, const std::vector<int>& orbits,
                   const std::vector<space::Offset>& offsets) {
    append_vtk_integers(text, "Int64", "PeriodicPointIds", orbits);
    open_vtk_array(text, "Int32", "PeriodicOffset", " NumberOfComponents=\"3\"");
    for (const space::Offset& offset : offsets) {
        for (const int number : {offset.i, offset.j, offset.k}) append_vtk_word(text, number);
        end_vtk_line(text);
    }
    close_vtk_array(text);
}

void append_space_points(std::string& text, const std::vector<space::Vec3>& points) {
    text += "<Points>\n";
    open_vtk_array(text, "Float64", "Points", " NumberOfComponents=\"3\"");
    for (const space::Vec3& p : points) append_space_vector(text, p);
    close_vtk_array(text);
    text += "</Points>\n";
}

space::Lattice read_space_lattice(const std::string& name, const VtuArrays& arrays) {
    const VtuArray& array = arrays.get("FieldData/PeriodicLattice", 3, 3, false);
    const Eigen::Map<const Eigen::Matrix3d> periods(array.values.data());
    try {
        return {periods.col(0), periods.col(1), periods.col(2)};
    } catch (const InvalidInput& fault) {
        fail(name, array.line, fault.what());
    }
}

double read_short_edges(const std::string& name, const VtuArrays& arrays) {
    if (arrays.find("FieldData/ShortEdges") == nullptr) return 0;
    const VtuArray& array = arrays.get("FieldData/ShortEdges", 1, 1, false);
    const double length = array.values[0];
    if (!(length >= 0 && length <= space::kLongestShortEdge)) {
        fail(name, array.line, kShortEdgesRange);
    }
    return length;
}

std::vector<space::Vec3> read_space_points(const std::string& name, const VtuArrays& arrays) {
    const VtuArray& array = arrays.get("Points/Points", arrays.n_points(), 3, false);
    if (array.type != "Float64") {
        fail(name, array.line,
             "the points are " + array.type + ", too coarse for a proof; write Float64");
    }
    std::vector<space::Vec3> points;
    for (std::size_t k = 0; k < array.size(); k += 3) {
        points.emplace_back(array.values[k], array.values[k + 1], array.values[k + 2]);
    }
    return points;
}

double stated_mismatch(const VtuArrays& arrays, const space::Lattice& lattice,
                       const std::vector<space::Vec3>& points) {
    if (arrays.find("PointData/PeriodicPointIds") == nullptr) return 0;
    const auto n = static_cast<int>(points.size());
    const VtuArray& orbits = arrays.get("PointData/PeriodicPointIds", n, 1, true);
    const VtuArray& offsets = arrays.get("PointData/PeriodicOffset", n, 3, true);
    double largest = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        const int first = orbits.integer(v);
        if (first < 0 || first >= n) continue;
        const space::Offset offset{offsets.integer(3 * v), offsets.integer(3 * v + 1),
                                   offsets.integer(3 * v + 2)};
        const space::Vec3 image = points[first] + lattice.translation(offset);
        largest = std::max(largest, (image - points[v]).cwiseAbs().maxCoeff());
    }
    return largest;
}

void compare_images(const std::string& name, const VtuArrays& arrays,
                    const std::vector<int>& orbits, const std::vector<space::Offset>& offsets) {
    if (arrays.find("PointData/PeriodicPointIds") == nullptr) return;
    const auto n = static_cast<int>(orbits.size());
    const VtuArray& stated_orbits = arrays.get("PointData/PeriodicPointIds", n, 1, true);
    const VtuArray& stated_offsets = arrays.get("PointData/PeriodicOffset", n, 3, true);
    for (std::size_t v = 0; v < orbits.size(); ++v) {
        const space::Offset stated{stated_offsets.integer(3 * v), stated_offsets.integer(3 * v + 1),
                                   stated_offsets.integer(3 * v + 2)};
        if (stated_orbits.integer(v) == orbits[v] && stated == offsets[v]) continue;
        fail(name, stated_orbits.lines[v],
             "point " + std::to_string(v) + " is point " + std::to_string(orbits[v]) +
                 " moved by " + in_words(offsets[v]) +
                 ", and the file states another image; write the file again with pcvt");
    }
}

}  // namespace pcvt
