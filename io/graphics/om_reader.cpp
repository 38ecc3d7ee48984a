#include "io/graphics/om_reader.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "io/graphics/om_bytes.hpp"
#include "io/tiles/site_notes.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/tile/tile_holes.hpp"

namespace pcvt {
namespace {

/// The format of OpenMesh 9, and the chunk headers of each part of our files.
constexpr char kVersion = 'B';
constexpr unsigned kPositions = 0x5600;
constexpr unsigned kEnd = 0x001c;
constexpr unsigned kKindMask = 0x01ff;
constexpr unsigned kTopologyOfVertices = 0x00e0;
constexpr unsigned kTopologyOfHalfedges = 0x00f8;
constexpr unsigned kTopologyOfFaces = 0x00e8;
/// Set in the header of a chunk with a name, which holds a property.
constexpr unsigned kIsNamed = 0x0002;

class OmParser : OmBytes {
   public:
    OmParser(const std::string& name, std::string_view bytes) : OmBytes(name, bytes) {}

    TileFile parse() {
        read_header();
        while (read_chunk()) {
        }
        if (!is_at_end()) throw_bad_file("has data after its end");
        Tile tile{.lattice = lattice(), .kind = kind_, .points = std::move(points_)};
        read_faces(tile);
        read_orbits(tile);
        read_partners(tile);
        read_sites(tile);
        read_holes(tile);
        return {std::move(tile), Precision::kDouble, true, true};
    }

   private:
    void read_header() {
        const std::string_view magic = take(4);
        const bool known = magic.substr(0, 2) == "OM" && (magic[2] == 'P' || magic[2] == 'T');
        if (!known || magic[3] != kVersion) throw_bad_file("is not a mesh as OpenMesh 9 writes it");
        kind_ = magic[2] == 'P' ? MeshKind::kVoronoi : MeshKind::kDelaunay;
        n_vertices_ = read_count();
        n_faces_ = read_count();
        n_halfedges_ = 2 * read_count();
        if (n_vertices_ == 0 || n_faces_ == 0 || n_halfedges_ == 0) throw_bad_file("holds no face");
    }

    /// Reads the next chunk; returns false at the end of the file.
    bool read_chunk() {
        const std::size_t header = read_size(2);
        if (header == kEnd) return false;
        const std::size_t width = std::size_t{1} << (header >> 14);
        if ((header & kIsNamed) != 0) {
            read_property();
        } else if (header == kPositions && points_.empty()) {
            read_positions();
        } else if ((header & kKindMask) == kTopologyOfVertices) {
            vertex_halfedge_ = read_handles(n_vertices_, width);
        } else if ((header & kKindMask) == kTopologyOfHalfedges && halfedges_.empty()) {
            halfedges_ = read_handles(3 * n_halfedges_, width);
        } else if ((header & kKindMask) == kTopologyOfFaces && face_halfedge_.empty()) {
            face_halfedge_ = read_handles(n_faces_, width);
        } else {
            throw_bad_file("has an unknown chunk");
        }
        return true;
    }

    void read_positions() {
        for (std::size_t v = 0; v < n_vertices_; ++v) {
            checkpoint_each(v);
            const std::string_view bytes = take(24);
            const Vec2 p(double_of(bytes), double_of(bytes.substr(8)));
            if (!p.allFinite() || double_of(bytes.substr(16)) != 0) {
                throw_bad_file("has a vertex that is not finite or not in the plane z = 0");
            }
            points_.push_back(p);
        }
    }

    std::vector<std::int64_t> read_handles(std::size_t count, std::size_t width) {
        std::vector<std::int64_t> handles;
        const std::string_view bytes = take(count * width);
        for (std::size_t k = 0; k < count; ++k) {
            checkpoint_each(k);
            handles.push_back(integer_of(bytes.substr(k * width, width)));
        }
        return handles;
    }

    void read_property() {
        const std::string_view property = take(read_size(1));
        take(read_size(1));
        properties_[property] = take(read_size(4));
    }

    std::string_view property(const char* name, std::size_t n_bytes) const {
        const auto found = properties_.find(name);
        if (found == properties_.end()) throw_bad_file(std::string("has no property ") + name);
        if (found->second.size() != n_bytes)
            throw_bad_file(std::string("has too little or too much ") + name);
        return found->second;
    }

    std::vector<int> integers(const char* name, std::size_t dimension, std::size_t count) const {
        const std::string_view bytes = property(name, 4 * dimension * count);
        std::vector<int> values;
        for (std::size_t k = 0; k < dimension * count; ++k) {
            values.push_back(static_cast<int>(integer_of(bytes.substr(4 * k, 4))));
        }
        return values;
    }

    /// Returns a property of the mesh that is a list: its length, then its entries.
    std::vector<double> numbers(const char* name) const {
        const auto found = properties_.find(name);
        const std::string_view bytes =
            found == properties_.end() ? std::string_view() : found->second;
        if (bytes.size() < 4 ||
            bytes.size() != 4 + 8 * static_cast<std::uint64_t>(integer_of(bytes.substr(0, 4)))) {
            throw_bad_file(std::string("has too little or too much ") + name);
        }
        std::vector<double> values;
        for (std::size_t at = 4; at < bytes.size(); at += 8) {
            values.push_back(double_of(bytes.substr(at)));
            if (!std::isfinite(values.back())) throw_bad_file(std::string(name) + " is not finite");
        }
        return values;
    }

    Lattice lattice() const {
        const std::vector<double> n = numbers("pcvt_lattice");
        if (n.size() != 4) throw_bad_file("has too little or too much pcvt_lattice");
        try {
            return {Vec2(n[0], n[1]), Vec2(n[2], n[3])};
        } catch (const InvalidInput& fault) {
            throw_other_fault(fault);
        }
    }

    void read_sites(Tile& tile) const {
        std::vector<int> of_faces = integers("pcvt_face_site", 1, n_faces_);
        std::vector<int> of_vertices = integers("pcvt_vertex_site", 1, n_vertices_);
        // A mesh of triangles with face sites holds grains.
        if (kind_ == MeshKind::kDelaunay && of_faces[0] >= 0) tile.kind = MeshKind::kGrains;
        const bool owned = faces_have_sites(tile.kind);
        for (const int site : owned ? of_vertices : of_faces) {
            if (site != -1) throw_bad_file("has sites of faces and of vertices");
        }
        (owned ? tile.face_site : tile.vertex_site) = std::move(owned ? of_faces : of_vertices);
        // Earlier versions wrote no positions.
        if (!properties_.contains("pcvt_sites")) return;
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

    void read_holes(Tile& tile) const {
        if (!properties_.contains("pcvt_holes")) return;
        try {
            take_holes(numbers("pcvt_holes"), tile);
        } catch (const InvalidInput& fault) {
            throw_other_fault(fault);
        }
    }

    /// Reads a note with a property of its own; an empty one states nothing.
    void read_note(const SiteNote& note, SiteNotes& notes) const {
        if (note.property.empty() || !properties_.contains(note.property)) return;
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

    std::size_t checked(std::int64_t index, std::size_t count) const {
        if (index < 0 || static_cast<std::size_t>(index) >= count) {
            throw_bad_file("names a vertex or an edge that does not exist");
        }
        return static_cast<std::size_t>(index);
    }

    std::size_t next(std::size_t h) const { return checked(halfedges_[3 * h], n_halfedges_); }
    int to_vertex(std::size_t h) const {
        return static_cast<int>(checked(halfedges_[3 * h + 1], n_vertices_));
    }
    int from_vertex(std::size_t h) const { return to_vertex(h ^ 1); }

    bool is_boundary(std::size_t h) const { return halfedges_[3 * h + 2] == -1; }

    /// Proves the invariants of OpenMesh: the next halfedge begins where a halfedge ends, at
    /// the same face; a vertex names a halfedge that leaves it, on the boundary if it lies there.
    void require_connectivity() const {
        if (vertex_halfedge_.size() != n_vertices_) throw_bad_file("lacks its vertices");
        std::vector<bool> at_boundary(n_vertices_, false);
        for (std::size_t h = 0; h < n_halfedges_; ++h) {
            checkpoint_each(h);
            if (halfedges_[3 * h + 2] < -1 || from_vertex(next(h)) != to_vertex(h) ||
                halfedges_[3 * next(h) + 2] != halfedges_[3 * h + 2]) {
                throw_bad_file("has halfedges that do not follow each other");
            }
            if (is_boundary(h)) at_boundary[from_vertex(h)] = true;
        }
        for (std::size_t v = 0; v < n_vertices_; ++v) {
            const std::size_t h = checked(vertex_halfedge_[v], n_halfedges_);
            if (from_vertex(h) == static_cast<int>(v) && is_boundary(h) == at_boundary[v]) continue;
            throw_bad_file("has a vertex with a halfedge of another vertex");
        }
    }

    void read_faces(Tile& tile) const {
        if (tile.points.empty() || halfedges_.empty() || face_halfedge_.empty()) {
            throw_bad_file("lacks its vertices or its faces");
        }
        require_connectivity();
        for (std::size_t f = 0; f < n_faces_; ++f) {
            checkpoint_each(f);
            const std::size_t first = checked(face_halfedge_[f], n_halfedges_);
            std::size_t h = first;
            do {
                if (halfedges_[3 * h + 2] != static_cast<std::int64_t>(f) ||
                    tile.faces.corners.size() == n_halfedges_) {
                    throw_bad_file("has a face that does not close");
                }
                tile.faces.corners.push_back(to_vertex(h));
                h = next(h);
            } while (h != first);
            tile.faces.close();
            if (tile.face_size(static_cast<int>(f)) < 3)
                throw_bad_file("has a face without three corners");
        }
    }

    std::vector<int> offsets(const char* name, std::size_t count) const {
        std::vector<int> values = integers(name, 2, count);
        for (const int k : values) {
            if (k < -kLargestOffset || k > kLargestOffset)
                throw_bad_file("has an offset beyond 2^28");
        }
        return values;
    }

    void read_orbits(Tile& tile) const {
        const std::vector<int> orbit = integers("pcvt_orbit", 1, n_vertices_);
        const std::vector<int> offset = offsets("pcvt_orbit_offset", n_vertices_);
        for (std::size_t v = 0; v < n_vertices_; ++v) {
            checkpoint_each(v);
            const auto representative = checked(orbit[v], n_vertices_);
            const bool is_moved = offset[2 * v] != 0 || offset[2 * v + 1] != 0;
            if (representative == v && is_moved) throw_bad_file("moves a vertex to itself");
            if (representative == v) continue;
            tile.vertex_pairs.push_back(
                {orbit[v], static_cast<int>(v), {offset[2 * v], offset[2 * v + 1]}});
        }
    }

    void read_partners(Tile& tile) const {
        const std::vector<int> partner = integers("pcvt_partner", 1, n_halfedges_);
        const std::vector<int> offset = offsets("pcvt_partner_offset", n_halfedges_);
        const auto is_stated = [this](std::string_view name) {
            const auto found = properties_.find(name);
            return found != properties_.end() && found->second.size() > 4;
        };
        const bool has_walls = is_stated("pcvt_walls") || is_stated("pcvt_holes");
        for (std::size_t h = 0; h < n_halfedges_; ++h) {
            checkpoint_each(h);
            const Offset across{offset[2 * h], offset[2 * h + 1]};
            // Boundary edges on walls have no partner; the proof finds them.
            if (has_walls && partner[h] == -1 && across == Offset{}) continue;
            if (is_boundary(h) != (partner[h] >= 0) || partner[h] < -1 ||
                (across != Offset{}) != is_boundary(h)) {
                throw_bad_file("has partners that are not those of the boundary");
            }
            if (partner[h] < 0) continue;
            const std::size_t p = checked(partner[h], n_halfedges_);
            const Offset back{offset[2 * p], offset[2 * p + 1]};
            if (partner[p] != static_cast<int>(h) || across + back != Offset{}) {
                throw_bad_file("has a boundary edge whose partner has another partner");
            }
            if (across < Offset{}) continue;
            tile.edge_pairs.push_back({.v0 = to_vertex(h),
                                       .v1 = from_vertex(h),
                                       .w0 = from_vertex(p),
                                       .w1 = to_vertex(p),
                                       .offset = across});
        }
    }

    MeshKind kind_ = MeshKind::kVoronoi;
    std::size_t n_vertices_ = 0;
    std::size_t n_faces_ = 0;
    std::size_t n_halfedges_ = 0;
    std::vector<Vec2> points_;
    /// For each halfedge: the next halfedge, the vertex that it points to, and its face or -1.
    std::vector<std::int64_t> halfedges_;
    std::vector<std::int64_t> face_halfedge_;
    std::vector<std::int64_t> vertex_halfedge_;
    std::map<std::string_view, std::string_view> properties_;
};

}  // namespace

TileFile decode_om(const std::vector<EncodedFile>& files, const std::optional<Lattice>&) {
    return OmParser(files.front().path, files.front().bytes).parse();
}

}  // namespace pcvt
