#include "io/space/space_vtu_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/text.hpp"
#include "io/bytes/vtk_text.hpp"
#include "io/solvers/vtu_arrays.hpp"
#include "io/space/space_vtu_parts.hpp"
#include "io/space/space_vtu_writer.hpp"
#include "mesher/plane/proof/validate.hpp"
#include "mesher/space/mesh/cell_faces.hpp"

namespace pcvt {
namespace {

/// Volumes that a file states may differ by this part of the volume: by the order of summation.
constexpr double kVolumeError = 1e-10;

constexpr std::array<std::string_view, 5> kArrays{
    "Cells/faces", "Cells/faceoffsets", "CellData/Faces", "CellData/Volume", "CellData/Site"};

/// Walks over the numbers of an array.
class ArrayWalk {
   public:
    ArrayWalk(std::string name, const VtuArray& array) : name_(std::move(name)), array_(array) {}

    std::size_t at() const { return at_; }
    bool ended() const { return at_ == array_.size(); }
    /// The next number, from `least` to `most`.
    int take(int least, int most) {
        if (ended()) fail(array_.line, "the array ends within a cell; give the whole file");
        const int number = array_.integer(at_);
        if (number < least || number > most) {
            fail(array_.lines[at_], std::to_string(number) + " is not a number from " +
                                        std::to_string(least) + " to " + std::to_string(most) +
                                        "; correct it");
        }
        ++at_;
        return number;
    }
    [[noreturn]] void fail(int line, const std::string& complaint) const {
        throw BadFile(name_ + ":" + std::to_string(line) + ": " + complaint);
    }
    /// Fails unless `number`, the one before the k-th end, is that of the file.
    void require(const VtuArray& stated, std::size_t k, std::size_t number) const {
        if (stated.values[k] == static_cast<double>(number)) return;
        fail(stated.lines[k], "another number, " + std::to_string(number) +
                                  ", follows from the cells; write the file again with pcvt");
    }

   private:
    std::string name_;
    const VtuArray& array_;
    std::size_t at_ = 0;
};

/// Reads the arrays of one file.
class VtuCells {
   public:
    VtuCells(const EncodedFile& vtu)
        : name_(vtu.path),
          is_own_(vtu.bytes.find(kSpaceVtuMark) != std::string::npos),
          arrays_(vtu.path, vtu.bytes, kArrays),
          n_(arrays_.n_cells()) {}

    SpaceTile read(double tolerance) const {
        if (n_ == 0) throw BadFile(name_ + ": holds no cell; give a grid of polyhedra");
        require_types();
        const space::PolyhedronList cells = read_cells();
        compare_connectivity(cells);
        SpaceTile tile{.mesh = assembled(cells, tolerance)};
        tile.mesh.short_edges = read_short_edges(name_, arrays_);
        compare_images(name_, arrays_, tile.mesh.point_orbit, tile.mesh.point_offset);
        compare_cells(tile.mesh, cells);
        if (arrays_.find("CellData/Site") != nullptr) {
            const VtuArray& sites = arrays_.get("CellData/Site", n_, 3, false);
            tile.sites = Eigen::Map<const space::Points>(sites.values.data(), 3, n_);
        }
        return tile;
    }

   private:
    /// A file whose sides agree less closely than within the tolerance may state how far.
    space::PolyhedralMesh assembled(const space::PolyhedronList& cells, double tolerance) const {
        const space::Lattice lattice = read_space_lattice(name_, arrays_);
        try {
            return assembled_mesh(lattice, cells, tolerance);
        } catch (const NotATile& fault) {
            const double mismatch = stated_mismatch(arrays_, lattice, cells.points);
            if (!(mismatch > tolerance)) throw;
            throw SeamMismatch(fault.what(), mismatch);
        }
    }

    [[noreturn]] void fail(int line, const std::string& complaint) const {
        throw BadFile(name_ + ":" + std::to_string(line) + ": " + complaint);
    }

    void require_types() const {
        const VtuArray& types = arrays_.get("Cells/types", n_, 1, true);
        for (std::size_t k = 0; k < types.size(); ++k) {
            if (types.integer(k) == kVtkPolyhedron) continue;
            fail(types.lines[k],
                 "a cell is no polyhedron (type 42) beside others that are; "
                 "leave it out");
        }
    }

    space::PolyhedronList read_cells() const {
        space::PolyhedronList cells;
        cells.points = read_space_points(name_, arrays_);
        const VtuArray& faces = arrays_.get("Cells/faces", -1, 1, true);
        const VtuArray& ends = arrays_.get("Cells/faceoffsets", n_, 1, true);
        ArrayWalk walk(name_, faces);
        const int most = static_cast<int>(cells.points.size());
        for (int s = 0; s < n_; ++s) {
            for (int left = walk.take(4, most * 2); left > 0; --left) {
                for (int k = walk.take(3, most); k > 0; --k) {
                    cells.faces.corners.push_back(walk.take(0, most - 1));
                }
                cells.faces.close();
            }
            cells.cell_begin.push_back(cells.faces.n_faces());
            walk.require(ends, static_cast<std::size_t>(s), walk.at());
        }
        if (!walk.ended()) fail(faces.lines[walk.at()], "a number follows the last cell");
        return cells;
    }

    /// The points of each cell, in any order, are those of its faces.
    void compare_connectivity(const space::PolyhedronList& cells) const {
        const VtuArray& points = arrays_.get("Cells/connectivity", -1, 1, true);
        const VtuArray& ends = arrays_.get("Cells/offsets", n_, 1, true);
        ArrayWalk walk(name_, points);
        for (int s = 0; s < n_; ++s) {
            const std::vector<int> wanted = cell_points(cells, s);
            std::vector<int> found;
            for (std::size_t k = 0; k < wanted.size(); ++k) {
                found.push_back(walk.take(0, arrays_.n_points() - 1));
            }
            std::sort(found.begin(), found.end());
            if (found != wanted) {
                fail(points.line, "cell " + std::to_string(s) + " has other points than its faces");
            }
            walk.require(ends, static_cast<std::size_t>(s), walk.at());
        }
        if (!walk.ended()) fail(points.lines[walk.at()], "a number follows the last cell");
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
            if (ids != nullptr && ids->integer(k) != s) {
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

    std::string name_;
    /// Whether pcvt wrote the file; other programs may take volumes by other rules, and round them.
    bool is_own_;
    VtuArrays arrays_;
    int n_;
};

}  // namespace

bool holds_polyhedra(const EncodedFile& vtu) {
    return vtu.bytes.find("Name=\"faceoffsets\"") != std::string::npos;
}

SpaceTile decode_space_vtu(const EncodedFile& vtu, double tolerance) {
    refuse_binary(vtu.path, vtu.bytes, "export it as ASCII");
    return VtuCells(vtu).read(tolerance);
}

}  // namespace pcvt
