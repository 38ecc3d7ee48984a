#include "io/solvers/vtu_volumes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/point_offsets.hpp"
#include "io/solvers/vtu_arrays.hpp"
#include "io/solvers/vtu_writer.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/space/mesh/cell_faces.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/mesh/short_edges.hpp"

namespace pcvt {
namespace {

/// Volumes that a file states may differ by this part of the volume: by the order of summation.
constexpr double kVolumeError = 1e-10;

constexpr std::string_view kOrientationArray = "CellData/Orientation";
constexpr std::array<std::string_view, 7> kPolyhedraArrays{
    "Cells/faces",   "Cells/faceoffsets", "CellData/Faces", "CellData/Volume",
    "CellData/Site", "CellData/Weight",   kOrientationArray};

/// "(1, 0, -1)"
std::string in_words(const space::Offset& offset) {
    return "(" + std::to_string(offset.i) + ", " + std::to_string(offset.j) + ", " +
           std::to_string(offset.k) + ")";
}

/// Returns PolyhedralMesh::short_edges, which a file without removed edges does not state.
double read_short_edges(const VtuArrays& arrays) {
    if (arrays.find("FieldData/ShortEdges") == nullptr) return 0;
    const VtuArray& array = arrays.get("FieldData/ShortEdges", 1, 1, false);
    const double length = array.values[0];
    if (!(length >= 0 && length <= space::kLongestShortEdge)) {
        arrays.scanner().throw_bad_file(array.line, kShortEdgesRange);
    }
    return length;
}

/// Returns PolyhedralMesh::metric, which a file of round cells does not state.
space::Metric read_metric(const VtuArrays& arrays) {
    if (arrays.find("FieldData/Metric") == nullptr) return {};
    const VtuArray& array = arrays.get("FieldData/Metric", 4, 1, false);
    try {
        return {array.values[0], {array.values[1], array.values[2], array.values[3]}};
    } catch (const InvalidInput& fault) {
        arrays.scanner().throw_bad_file(array.line, fault.what());
    }
}

std::vector<space::Vec3> read_points(const VtuArrays& arrays) {
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

/// The images that a file states for its points.
class StatedImages {
   public:
    /// @throws BadFile  the images are not one for each point.
    explicit StatedImages(const VtuArrays& arrays) : scanner_(arrays.scanner()) {
        if (arrays.find("PointData/PeriodicPointIds") == nullptr) return;
        orbits_ = &arrays.get("PointData/PeriodicPointIds", arrays.n_points(), 1, true);
        offsets_ = &arrays.get("PointData/PeriodicOffset", arrays.n_points(), 3, true);
    }

    /// Returns the largest distance of a point from its image, in one coordinate, length units; 0
    /// if the file states none.
    double mismatch(const space::Lattice& lattice, const std::vector<space::Vec3>& points) const {
        double largest = 0;
        for (std::size_t v = 0; orbits_ != nullptr && v < points.size(); ++v) {
            const int first = orbits_->integer(v);
            if (first < 0 || std::cmp_greater_equal(first, points.size())) continue;
            const space::Vec3 image = points[first] + lattice.translation(offset(v));
            largest = std::max(largest, (image - points[v]).cwiseAbs().maxCoeff());
        }
        return largest;
    }

    /// Compares the images, if the file states any, with those of its points.
    /// @throws BadFile  naming the point.
    void compare(const std::vector<int>& orbits, const std::vector<space::Offset>& offsets) const {
        for (std::size_t v = 0; orbits_ != nullptr && v < orbits.size(); ++v) {
            if (orbits_->integer(v) == orbits[v] && offset(v) == offsets[v]) continue;
            scanner_.throw_bad_file(
                orbits_->lines[v],
                "point " + std::to_string(v) + " is point " + std::to_string(orbits[v]) +
                    " moved by " + in_words(offsets[v]) +
                    ", and the file states another image; write the file again with pcvt");
        }
    }

   private:
    space::Offset offset(std::size_t v) const {
        return {offsets_->integer(3 * v), offsets_->integer(3 * v + 1),
                offsets_->integer(3 * v + 2)};
    }

    const XmlScanner& scanner_;
    const VtuArray* orbits_ = nullptr;
    const VtuArray* offsets_ = nullptr;
};

/// Reads the materials of cells.
/// @param cell_of  the cell of each element: cell by cell, without a gap.
CellMaterials read_materials(const VtuArrays& arrays, const std::vector<SiteId>& cell_of) {
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

/// Reads the arrays of polyhedra of one file.
class VtuPolyhedra {
   public:
    explicit VtuPolyhedra(const EncodedFile& vtu)
        : is_own_(vtu.bytes.find(kPolyhedraVtuMark) != std::string::npos),
          arrays_(vtu.path, vtu.bytes, kPolyhedraArrays),
          n_(arrays_.n_cells()) {
        if (n_ == 0) throw BadFile(vtu.path + ": holds no cell; give a grid of polyhedra");
    }

    SpaceTile read(double tolerance) const {
        const space::PolyhedronList cells = read_faces();
        compare_points(cells);
        SpaceTile tile{.mesh = assembled(cells, tolerance)};
        tile.mesh.short_edges = read_short_edges(arrays_);
        tile.mesh.metric = read_metric(arrays_);
        StatedImages(arrays_).compare(tile.mesh.point_orbit, tile.mesh.point_offset);
        if (arrays_.find("CellData/Site") != nullptr) {
            const VtuArray& sites = arrays_.get("CellData/Site", n_, 3, false);
            tile.sites = Eigen::Map<const space::Points>(sites.values.data(), 3, n_);
        }
        tile.mesh.piece_cell = cells_of_pieces(tile.mesh.lattice, tile.sites);
        compare_cells(tile.mesh, cells);
        if (arrays_.find("CellData/Weight") != nullptr) {
            const VtuArray& weights = arrays_.get("CellData/Weight", n_, 1, false);
            tile.weights = Eigen::Map<const Eigen::VectorXd>(weights.values.data(), n_);
        }
        std::vector<SiteId> cell_of(static_cast<std::size_t>(n_));
        std::iota(cell_of.begin(), cell_of.end(), 0);
        tile.materials = read_materials(arrays_, cell_of);
        return tile;
    }

   private:
    [[noreturn]] void fail(int line, const std::string& complaint) const {
        arrays_.scanner().throw_bad_file(line, complaint);
    }

    /// A file whose sides agree less closely than within the tolerance may state how far.
    space::PolyhedralMesh assembled(const space::PolyhedronList& cells, double tolerance) const {
        const auto lattice = read_vtu_lattice<space::Lattice>(arrays_);
        try {
            return assembled_mesh(lattice, cells, tolerance);
        } catch (const NotATile& fault) {
            const double mismatch = StatedImages(arrays_).mismatch(lattice, cells.points);
            if (!(mismatch > tolerance)) throw;
            throw SeamMismatch(fault.what(), mismatch);
        }
    }

    /// Takes number `at` of the faces, from `least` to `most`.
    int take(const VtuArray& faces, std::size_t& at, int least, int most) const {
        if (at == faces.size()) {
            fail(faces.line, "the array ends within a cell; give the whole file");
        }
        const int number = faces.integer(at);
        if (number < least || number > most) {
            fail(faces.lines[at], std::to_string(number) + " is not a number from " +
                                      std::to_string(least) + " to " + std::to_string(most) +
                                      "; correct it");
        }
        ++at;
        return number;
    }

    space::PolyhedronList read_faces() const {
        space::PolyhedronList cells;
        cells.points = read_points(arrays_);
        const VtuArray& faces = arrays_.get("Cells/faces", -1, 1, true);
        const VtuArray& ends = arrays_.get("Cells/faceoffsets", n_, 1, true);
        const int most = static_cast<int>(cells.points.size());
        std::size_t at = 0;
        for (int s = 0; s < n_; ++s) {
            for (int left = take(faces, at, 4, most * 2); left > 0; --left) {
                for (int k = take(faces, at, 3, most); k > 0; --k) {
                    cells.faces.corners.push_back(take(faces, at, 0, most - 1));
                }
                cells.faces.close();
            }
            cells.cell_begin.push_back(cells.faces.n_faces());
            const auto k = static_cast<std::size_t>(s);
            if (ends.values[k] == static_cast<double>(at)) continue;
            fail(ends.lines[k], "another number, " + std::to_string(at) +
                                    ", follows from the cells; write the file again with pcvt");
        }
        if (at < faces.size()) fail(faces.lines[at], "a number follows the last cell");
        return cells;
    }

    /// The points of each cell, in any order, are those of its faces.
    void compare_points(const space::PolyhedronList& cells) const {
        const ElementList stated = read_vtu_cells(arrays_, {ElementKind::kPolyhedron});
        for (int s = 0; s < n_; ++s) {
            std::vector<int> points(stated.nodes[s].begin(), stated.nodes[s].end());
            std::sort(points.begin(), points.end());
            if (points == cell_points(cells, s)) continue;
            fail(arrays_.find("Cells/connectivity")->line,
                 "cell " + std::to_string(s) + " has other points than its faces");
        }
    }

    void compare_cells(const space::PolyhedralMesh& mesh,
                       const space::PolyhedronList& cells) const {
        const VtuArray* const ids = arrays_.find("CellData/CellId");
        const VtuArray* const faces = arrays_.find("CellData/Faces");
        const VtuArray* const volumes = arrays_.find("CellData/Volume");
        if (ids != nullptr) arrays_.get("CellData/CellId", n_, 1, true);
        if (faces != nullptr) arrays_.get("CellData/Faces", n_, 1, true);
        if (volumes != nullptr) arrays_.get("CellData/Volume", n_, 1, false);
        const std::vector<space::CellBody> bodies = cell_bodies(mesh);
        for (int s = 0; s < n_; ++s) {
            const auto k = static_cast<std::size_t>(s);
            const std::string cell = "cell " + std::to_string(s) + " ";
            if (ids != nullptr && ids->integer(k) != mesh.site_of(s)) {
                fail(ids->lines[k], cell + "is not that of its site; write the file again");
            }
            const int n_faces = cells.cell_begin[k + 1] - cells.cell_begin[k];
            if (faces != nullptr && faces->integer(k) != n_faces) {
                fail(faces->lines[k], cell + "has " + std::to_string(n_faces) + " faces");
            }
            const double volume = bodies[k].volume;
            if (volumes != nullptr && is_own_ &&
                !(std::abs(volumes->values[k] - volume) <= kVolumeError * volume)) {
                fail(volumes->lines[k], cell + "has another volume; write the file again");
            }
        }
    }

    /// Whether pcvt wrote the file; other programs may take volumes by other rules, and round them.
    bool is_own_;
    VtuArrays arrays_;
    int n_;
};

}  // namespace

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

bool holds_vtu_polyhedra(const EncodedFile& vtu) {
    return vtu.bytes.find("Name=\"faceoffsets\"") != std::string::npos;
}

bool holds_vtu_tetrahedra(const EncodedFile& vtu) {
    const std::size_t at = vtu.bytes.find("Name=\"PeriodicLattice\"");
    if (at == std::string::npos || holds_vtu_polyhedra(vtu)) return false;
    const std::size_t begin = vtu.bytes.rfind('<', at);
    const std::size_t end = vtu.bytes.find('>', at);
    if (begin == std::string::npos || end == std::string::npos) return false;
    return std::string_view(vtu.bytes).substr(begin, end - begin).find("NumberOfTuples=\"3\"") !=
           std::string_view::npos;
}

SpaceTile decode_vtu_polyhedra(const EncodedFile& vtu, double tolerance) {
    refuse_binary(vtu.path, vtu.bytes, "export it as ASCII");
    return VtuPolyhedra(vtu).read(tolerance);
}

TetrahedralTile decode_vtu_tetrahedra(const EncodedFile& vtu) {
    refuse_binary(vtu.path, vtu.bytes, "export it as ASCII");
    const VtuArrays arrays(vtu.path, vtu.bytes, std::array{kOrientationArray});
    const int n = arrays.n_points();
    if (arrays.n_cells() == 0 || n == 0) {
        throw BadFile(vtu.path + ": holds no tetrahedron; give the whole file");
    }
    TetrahedralTile tile{.mesh = {.lattice = read_vtu_lattice<space::Lattice>(arrays),
                                  .points = read_points(arrays)}};
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
    tile.materials = read_materials(arrays, mesh.cell);
    return tile;
}

void compare_vtu_tetrahedra(const EncodedFile& vtu, const TetrahedralTile& tile) {
    if (vtu.bytes.find(kTetrahedraVtuMark) == std::string::npos) return;
    require_same_bytes({vtu}, encode_vtu(vtu_grid(tile.mesh, &tile.materials), vtu.path));
}

}  // namespace pcvt
