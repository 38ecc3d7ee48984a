#include "io/solvers/vtu_reader.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/file_tile_builder.hpp"
#include "io/forms/midside_nodes.hpp"
#include "io/forms/site_notes.hpp"
#include "io/solvers/vtu_arrays.hpp"
#include "mesher/cells/phase_fractions.hpp"

namespace pcvt {
namespace {

/// Turns the arrays into a tile.
class VtuTile {
   public:
    VtuTile(const std::string& name, const VtuArrays& arrays)
        : arrays_(arrays), file_{.name = name, .index_base = 0} {}

    FileTileBuilder make(const std::optional<plane::Lattice>& lattice, plane::Precision precision) {
        take_points();
        take_faces();
        if (arrays_.find("FieldData/PeriodicLattice")) {
            file_.lattice = read_vtu_lattice<plane::Lattice>(arrays_);
        }
        if (arrays_.find("FieldData/SitePositions")) take_site_notes();
        if (arrays_.find("FieldData/HoleNames")) take_holes();
        if (arrays_.find("PointData/PeriodicPointIds")) take_orbits();
        take_kind_and_sites();
        if (!file_.sites.empty() && arrays_.find("CellData/Orbit")) take_site_orbits();
        if (!file_.sites.empty() && arrays_.find("FieldData/SitePhases")) {
            read_vtu_phases(arrays_, "FieldData/SitePhases", -1, file_.materials);
        }
        if (kind_ == ElementKind::kTriangle6) remove_midside_nodes(file_, lattice, precision);
        return std::move(file_);
    }

   private:
    [[noreturn]] void throw_bad_file(int line, const std::string& complaint) const {
        arrays_.scanner().throw_bad_file(line, complaint);
    }

    void take_points() {
        const VtuArray& points = arrays_.get("Points/Points", arrays_.n_points(), 3, false);
        for (std::size_t k = 0; k < points.size(); k += 3) {
            if (points.values[k + 2] != 0) {
                throw_bad_file(points.lines[k + 2], "z is not 0; move the tile to the plane z = 0");
            }
            file_.points.emplace_back(points.values[k], points.values[k + 1]);
        }
    }

    void take_faces() {
        ElementList cells = read_vtu_cells(
            arrays_, {ElementKind::kPolygon, ElementKind::kTriangle3, ElementKind::kTriangle6});
        const std::vector<int>& lines = arrays_.find("Cells/connectivity")->lines;
        for (int f = 0; f < cells.size(); ++f) {
            file_.face_lines.push_back(lines[cells.nodes.begin[f]]);
        }
        kind_ = cells.kind;
        file_.faces = std::move(cells.nodes);
    }

    void take_site_notes() {
        for (const SiteNote& note : site_notes()) {
            const std::string key = "FieldData/" + std::string(note.array);
            if (!note.always_in_arrays && arrays_.find(key) == nullptr) continue;
            const int n_tuples = note.of_each_site ? -1 : static_cast<int>(note.n_parts);
            const int width = note.of_each_site ? static_cast<int>(note.n_parts) : 1;
            const VtuArray& array = arrays_.get(key, n_tuples, width, note.of_integers);
            try {
                take_note(note, array.values, file_.notes);
            } catch (const InvalidInput& fault) {
                throw_bad_file(array.line, fault.what());
            }
        }
    }

    void take_holes() {
        const std::vector<std::string> names = read_vtu_strings(arrays_, "FieldData/HoleNames");
        const VtuArray& edges = arrays_.get("FieldData/HoleEdges", -1, 3, true);
        for (std::size_t k = 0; k < edges.size(); k += 3) {
            const int hole = edges.integer(k);
            if (hole < 0 || hole >= std::ssize(names)) {
                throw_bad_file(edges.lines[k], "an edge lies at a hole without a name");
            }
            try {
                file_.notes.add_hole_edge(names[std::size_t(hole)], edges.values[k + 1],
                                          edges.values[k + 2]);
            } catch (const InvalidInput& fault) {
                throw_bad_file(edges.lines[k], fault.what());
            }
        }
    }

    void take_orbits() {
        const int n = arrays_.n_points();
        const VtuArray& orbits = arrays_.get("PointData/PeriodicPointIds", n, 1, true);
        const VtuArray& offsets = arrays_.get("PointData/PeriodicOffset", n, 2, true);
        for (int v = 0; v < n; ++v) {
            const auto k = static_cast<std::size_t>(v);
            const int orbit = orbits.integer(k);
            const plane::Offset offset{offsets.integer(2 * k), offsets.integer(2 * k + 1)};
            if (orbit < 0 || orbit >= n) {
                throw_bad_file(orbits.lines[k], "point " + std::to_string(orbit) +
                                                    " does not exist; correct the id");
            }
            if (orbit != v) {
                file_.vertex_pairs.push_back({orbit, v, offset});
            } else if (offset != plane::Offset{}) {
                throw_bad_file(offsets.lines[2 * k],
                               "a point has an offset to itself; write the file again with pcvt");
            }
        }
    }

    /// Triangles with sites at their points are Delaunay triangles; triangles with sites of their
    /// own are grains. Without PeriodicLattice, an array CellId has another meaning.
    void take_kind_and_sites() {
        const bool of_points = arrays_.find("PointData/CellId") != nullptr;
        const bool of_faces = arrays_.find("CellData/CellId") != nullptr && !of_points;
        file_.kind = kind_ == ElementKind::kPolygon ? plane::MeshKind::kVoronoi
                     : of_faces && file_.lattice    ? plane::MeshKind::kGrains
                                                    : plane::MeshKind::kDelaunay;
        const bool owned = faces_have_sites(*file_.kind);
        const std::string key = owned ? "CellData/CellId" : "PointData/CellId";
        if (arrays_.find(key) == nullptr || !file_.lattice) return;
        const VtuArray& sites =
            arrays_.get(key, owned ? arrays_.n_cells() : arrays_.n_points(), 1, true);
        for (std::size_t k = 0; k < sites.size(); ++k) file_.sites.push_back(sites.integer(k));
    }

    /// Turns the orbits of elements into those of sites.
    void take_site_orbits() {
        const VtuArray& orbits = arrays_.get("CellData/Orbit", arrays_.n_cells(), 1, true);
        const VtuArray& cells = arrays_.get("CellData/CellId", arrays_.n_cells(), 1, true);
        std::vector<int>& of_site = file_.site_orbits;
        // A site has a cell, or is a point of the Delaunay triangles.
        const int most = std::max(arrays_.n_cells(), arrays_.n_points());
        for (std::size_t f = 0; f < cells.size(); ++f) {
            const int cell = cells.integer(f);
            if (cell < 0 || cell >= most) {
                throw_bad_file(cells.lines[f],
                               "cell " + std::to_string(cell) + " does not exist; correct the id");
            }
            if (std::cmp_greater_equal(cell, of_site.size())) of_site.resize(cell + 1, -1);
            const int orbit = orbits.integer(f);
            if (orbit < 0 || (of_site[cell] >= 0 && of_site[cell] != orbit)) {
                throw_bad_file(orbits.lines[f], "cell " + std::to_string(cell) +
                                                    " has not one orbit, counted from 0; write " +
                                                    "the file again with pcvt");
            }
            of_site[cell] = orbit;
        }
    }

    const VtuArrays& arrays_;
    FileTileBuilder file_;
    ElementKind kind_ = ElementKind::kPolygon;
};

}  // namespace

TileFile decode_vtu(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice) {
    const EncodedFile& vtu = files.front();
    refuse_binary(vtu.path, vtu.bytes, "export it as ASCII");
    const VtuArrays arrays(vtu.path, vtu.bytes);
    const VtuArray* points = arrays.find("Points/Points");
    const bool single = points != nullptr && points->type == "Float32";
    const plane::Precision precision =
        single ? plane::Precision::kSingle : plane::Precision::kDouble;
    return finish(VtuTile(vtu.path, arrays).make(lattice, precision), lattice, precision);
}

}  // namespace pcvt
