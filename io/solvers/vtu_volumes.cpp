#include "io/solvers/vtu_volumes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/solvers/vtu_grid.hpp"
#include "io/solvers/vtu_space.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/space/mesh/cell_faces.hpp"
#include "mesher/space/mesh/cell_sites.hpp"
#include "mesher/space/mesh/short_edges.hpp"

namespace pcvt {
namespace {

/// Volumes that a file states may differ by this part of the volume: by the order of summation.
constexpr double kVolumeError = 1e-10;

constexpr std::array<std::string_view, 7> kPolyhedraArrays{
    "Cells/faces",   "Cells/faceoffsets", "CellData/Faces", "CellData/Volume",
    "CellData/Site", "CellData/Weight",   kOrientationArray};

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
        tile.materials = read_vtu_materials(arrays_, cell_of);
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
        cells.points = read_vtu_points(arrays_);
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

bool holds_vtu_polyhedra(const EncodedFile& vtu) {
    return vtu.bytes.find("Name=\"faceoffsets\"") != std::string::npos;
}

SpaceTile decode_vtu_polyhedra(const EncodedFile& vtu, double tolerance) {
    refuse_binary(vtu.path, vtu.bytes, "export it as ASCII");
    return VtuPolyhedra(vtu).read(tolerance);
}

}  // namespace pcvt
