#include "io/solvers/vtu_space.hpp"

#include <algorithm>
#include <utility>

#include "io/bytes/bad_file.hpp"

namespace pcvt {
namespace {

/// "(1, 0, -1)"
std::string in_words(const space::Offset& offset) {
    return "(" + std::to_string(offset.i) + ", " + std::to_string(offset.j) + ", " +
           std::to_string(offset.k) + ")";
}

}  // namespace

std::vector<space::Vec3> read_vtu_points(const VtuArrays& arrays) {
    const VtuArray& array = arrays.get("Points/Points", arrays.n_points(), 3, false);
    if (array.type != "Float64") {
        arrays.scanner().throw_bad_file(
            array.line, "the points are " + array.type + ", too coarse for a proof; write Float64");
    }
    std::vector<space::Vec3> points;
    for (std::size_t k = 0; k < array.size(); k += 3) {
        points.emplace_back(array.values[k], array.values[k + 1], array.values[k + 2]);
    }
    return points;
}

CellMaterials read_vtu_materials(const VtuArrays& arrays, const std::vector<SiteId>& cell_of) {
    CellMaterials materials;
    const int n_cells = cell_of.empty() ? 0 : cell_of.back() + 1;
    if (arrays.find("FieldData/PhaseNames") != nullptr) {
        read_vtu_phases(arrays, "FieldData/SitePhases", n_cells, materials);
    }
    if (arrays.find(std::string(kOrientationArray)) == nullptr) return materials;
    const VtuArray& angles = arrays.get(std::string(kOrientationArray), arrays.n_cells(), 3, false);
    for (std::size_t e = 0; e < cell_of.size(); ++e) {
        if (e > 0 && cell_of[e] == cell_of[e - 1]) continue;
        const std::size_t k = 3 * e;
        const BungeAngles of_cell{angles.values[k], angles.values[k + 1], angles.values[k + 2]};
        try {
            materials.site_orientation.push_back(checked_angles(of_cell));
        } catch (const InvalidInput& fault) {
            arrays.scanner().throw_bad_file(angles.lines[k], fault.what());
        }
    }
    return materials;
}

StatedImages::StatedImages(const VtuArrays& arrays) : scanner_(arrays.scanner()) {
    if (arrays.find("PointData/PeriodicPointIds") == nullptr) return;
    orbits_ = &arrays.get("PointData/PeriodicPointIds", arrays.n_points(), 1, true);
    offsets_ = &arrays.get("PointData/PeriodicOffset", arrays.n_points(), 3, true);
}

double StatedImages::mismatch(const space::Lattice& lattice,
                              const std::vector<space::Vec3>& points) const {
    double largest = 0;
    for (std::size_t v = 0; orbits_ != nullptr && v < points.size(); ++v) {
        const int first = orbits_->integer(v);
        if (first < 0 || std::cmp_greater_equal(first, points.size())) continue;
        const space::Vec3 image = points[first] + lattice.translation(offset(v));
        largest = std::max(largest, (image - points[v]).cwiseAbs().maxCoeff());
    }
    return largest;
}

void StatedImages::compare(const std::vector<int>& orbits,
                           const std::vector<space::Offset>& offsets) const {
    for (std::size_t v = 0; orbits_ != nullptr && v < orbits.size(); ++v) {
        if (orbits_->integer(v) == orbits[v] && offset(v) == offsets[v]) continue;
        scanner_.throw_bad_file(
            orbits_->lines[v],
            "point " + std::to_string(v) + " is point " + std::to_string(orbits[v]) + " moved by " +
                in_words(offsets[v]) +
                ", and the file states another image; write the file again with pcvt");
    }
}

}  // namespace pcvt
