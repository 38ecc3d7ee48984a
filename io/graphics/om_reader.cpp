#include "io/graphics/om_reader.hpp"

#include <cmath>
#include <utility>

#include "io/forms/site_notes.hpp"
#include "io/graphics/om_mesh.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/tile/tile_holes.hpp"

namespace pcvt {
namespace {

/// Makes the lattice of the numbers that a mesh states: make(numbers).
template <std::size_t kCount, class Make>
auto lattice_of(const OmMesh& mesh, const Make& make) {
    const std::vector<double> n = mesh.numbers("pcvt_lattice");
    if (n.size() != kCount) mesh.throw_bad_file("has too little or too much pcvt_lattice");
    try {
        return make(n);
    } catch (const InvalidInput& fault) {
        mesh.throw_other_fault(fault);
    }
}

/// Makes a tile of the mesh of a file.
class OmParser : public OmMesh {
   public:
    OmParser(const std::string& name, std::string_view bytes) : OmMesh(name, bytes) {}

    TileFile parse() {
        const plane::MeshKind kind =
            has_triangles() ? plane::MeshKind::kDelaunay : plane::MeshKind::kVoronoi;
        plane::Tile tile{.lattice = lattice(), .kind = kind};
        for (const auto& [x, y, z] : points()) {
            if (z != 0) throw_bad_file("has a vertex that is not in the plane z = 0");
            tile.points.emplace_back(x, y);
        }
        tile.faces = faces();
        read_orbits(tile);
        read_partners(tile);
        read_sites(tile);
        read_holes(tile);
        return {std::move(tile), plane::Precision::kDouble, true, true};
    }

   private:
    plane::Lattice lattice() const {
        return lattice_of<4>(*this, [](const std::vector<double>& n) {
            return plane::Lattice({n[0], n[1]}, {n[2], n[3]});
        });
    }

    void read_sites(plane::Tile& tile) const {
        std::vector<int> of_faces = integers("pcvt_face_site", 1, n_faces());
        std::vector<int> of_vertices = integers("pcvt_vertex_site", 1, n_vertices());
        // A mesh of triangles with face sites holds grains.
        if (has_triangles() && of_faces[0] >= 0) tile.kind = plane::MeshKind::kGrains;
        const bool owned = faces_have_sites(tile.kind);
        for (const int site : owned ? of_vertices : of_faces) {
            if (site != -1) throw_bad_file("has sites of faces and of vertices");
        }
        (owned ? tile.face_site : tile.vertex_site) = std::move(owned ? of_faces : of_vertices);
        // Earlier versions wrote no positions.
        if (!has_property("pcvt_sites")) return;
        const std::vector<double> sites = numbers("pcvt_sites");
        if (sites.empty()) return;
        const bool is_complete = sites.size() > 4 && sites.size() % 2 == 0 && sites[3] == 0;
        if (!is_complete || !(sites[2] >= 0 && sites[2] <= kLongestRemovedEdge)) {
            throw_bad_file("has no proper pcvt_sites");
        }
        SiteNotes notes{.columns = period_count(sites[0]),
                        .rows = period_count(sites[1]),
                        .short_edges = sites[2]};
        for (std::size_t k = 4; k < sites.size(); k += 2) {
            notes.positions.emplace_back(sites[k], sites[k + 1]);
        }
        for (const SiteNote& note : site_notes()) read_note(note, notes);
        std::move(notes).give_to(tile);
    }

    void read_holes(plane::Tile& tile) const {
        if (!has_property("pcvt_holes")) return;
        try {
            take_holes(numbers("pcvt_holes"), tile);
        } catch (const InvalidInput& fault) {
            throw_other_fault(fault);
        }
    }

    /// Reads a note with a property of its own; an empty one states nothing.
    void read_note(const SiteNote& note, SiteNotes& notes) const {
        if (note.property.empty() || !has_property(note.property)) return;
        const std::string name(note.property);
        const std::vector<double> values = numbers(name.c_str());
        if (values.empty()) return;
        try {
            take_note(note, values, notes);
        } catch (const InvalidInput& fault) {
            throw_bad_file("has no proper " + name + ": " + fault.what());
        }
    }

    int period_count(double n) const {
        if (!(n >= 1 && n <= kMostPeriods) || n != std::floor(n)) {
            throw_bad_file("has a number of periods that is not from 1 to " +
                           std::to_string(kMostPeriods));
        }
        return static_cast<int>(n);
    }

    void read_orbits(plane::Tile& tile) const {
        const std::vector<int> orbit = integers("pcvt_orbit", 1, n_vertices());
        const std::vector<int> offset = offsets("pcvt_orbit_offset", 2, n_vertices());
        for (std::size_t v = 0; v < n_vertices(); ++v) {
            checkpoint_each(v);
            const auto representative = checked(orbit[v], n_vertices());
            const bool is_moved = offset[2 * v] != 0 || offset[2 * v + 1] != 0;
            if (representative == v && is_moved) throw_bad_file("moves a vertex to itself");
            if (representative == v) continue;
            tile.vertex_pairs.push_back(
                {orbit[v], static_cast<int>(v), {offset[2 * v], offset[2 * v + 1]}});
        }
    }

    void read_partners(plane::Tile& tile) const {
        const std::vector<int> partner = integers("pcvt_partner", 1, n_halfedges());
        const std::vector<int> offset = offsets("pcvt_partner_offset", 2, n_halfedges());
        const bool has_walls = has_entries("pcvt_walls") || has_entries("pcvt_holes");
        for (std::size_t h = 0; h < n_halfedges(); ++h) {
            checkpoint_each(h);
            const plane::Offset across{offset[2 * h], offset[2 * h + 1]};
            // Boundary edges on walls have no partner; the proof finds them.
            if (has_walls && partner[h] == -1 && across == plane::Offset{}) continue;
            if (is_boundary(h) != (partner[h] >= 0) || partner[h] < -1 ||
                (across != plane::Offset{}) != is_boundary(h)) {
                throw_bad_file("has partners that are not those of the boundary");
            }
            if (partner[h] < 0) continue;
            const std::size_t p = checked(partner[h], n_halfedges());
            const plane::Offset back{offset[2 * p], offset[2 * p + 1]};
            if (partner[p] != static_cast<int>(h) || across + back != plane::Offset{}) {
                throw_bad_file("has a boundary edge whose partner has another partner");
            }
            if (across < plane::Offset{}) continue;
            tile.edge_pairs.push_back({.v0 = to_vertex(h),
                                       .v1 = from_vertex(h),
                                       .w0 = from_vertex(p),
                                       .w1 = to_vertex(p),
                                       .offset = across});
        }
    }
};

}  // namespace

TileFile decode_om(const std::vector<EncodedFile>& files, const std::optional<plane::Lattice>&) {
    return OmParser(files.front().path, files.front().bytes).parse();
}

bool holds_om_boundary(const EncodedFile& file) {
    return file.bytes.starts_with("OM") &&
           file.bytes.find("pcvt_face_partner") != std::string::npos;
}

space::TileSurface decode_om_boundary(const EncodedFile& om) {
    const OmMesh mesh(om.path, om.bytes);
    space::TileSurface surface{
        .lattice = lattice_of<9>(mesh, [](const std::vector<double>& n) {
            return space::Lattice({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]});
        })};
    for (const auto& [x, y, z] : mesh.points()) surface.points.emplace_back(x, y, z);
    surface.faces = mesh.faces();
    surface.cell = mesh.integers("pcvt_face_cell", 1, mesh.n_faces());
    surface.partner = mesh.integers("pcvt_face_partner", 1, mesh.n_faces());
    const std::vector<int> offsets = mesh.offsets("pcvt_face_offset", 3, mesh.n_faces());
    for (std::size_t k = 0; k < offsets.size(); k += 3) {
        surface.offset.push_back({offsets[k], offsets[k + 1], offsets[k + 2]});
    }
    const std::vector<double> sites = mesh.numbers("pcvt_sites");
    if (sites.size() % 3 != 0) mesh.throw_bad_file("has too little or too much pcvt_sites");
    surface.sites = Eigen::Map<const space::Points>(sites.data(), 3,
                                                    static_cast<Eigen::Index>(sites.size() / 3));
    return surface;
}

}  // namespace pcvt
