#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/graphics/om_bytes.hpp"
#include "mesher/base/faces.hpp"

namespace pcvt {

/// The mesh of an OpenMesh file: positions, connectivity and named properties, without their
/// meaning. All indices that its functions return exist.
///
/// Example usage:
///     const OmMesh mesh("tile.om", bytes);
///     const Faces faces = mesh.faces();
///     const std::vector<int> site = mesh.integers("pcvt_face_site", 1, mesh.n_faces());
///
/// Each function throws BadFile naming the file if the file lacks the property that it returns.
class OmMesh : protected OmBytes {
   public:
    /// Reads a whole file. @param name, bytes  must outlive the object.
    OmMesh(const std::string& name, std::string_view bytes);

    bool has_triangles() const { return has_triangles_; }
    std::size_t n_vertices() const { return n_vertices_; }
    std::size_t n_faces() const { return n_faces_; }
    std::size_t n_halfedges() const { return n_halfedges_; }
    /// Finite.
    const std::vector<std::array<double, 3>>& points() const { return points_; }
    /// The corners of each face from the target of its halfedge on. Proves the invariants of
    /// OpenMesh: the next halfedge begins where a halfedge ends, at the same face; a vertex names a
    /// halfedge that leaves it, on the boundary if it lies there; faces close and have three
    /// corners or more.
    Faces faces() const;

    bool has_property(std::string_view name) const { return properties_.contains(name); }
    /// Whether a property of the mesh that is a list has entries.
    bool has_entries(std::string_view name) const;
    /// A property of `count` elements with `dimension` integers each.
    std::vector<int> integers(const char* name, std::size_t dimension, std::size_t count) const;
    /// The same, of offsets up to 2^28.
    std::vector<int> offsets(const char* name, std::size_t dimension, std::size_t count) const;
    /// A property of the mesh that is a list of finite numbers.
    std::vector<double> numbers(const char* name) const;

    /// The index, which must be below `count`.
    std::size_t checked(std::int64_t index, std::size_t count) const;
    int to_vertex(std::size_t h) const;
    int from_vertex(std::size_t h) const { return to_vertex(h ^ 1); }
    bool is_boundary(std::size_t h) const { return halfedges_[3 * h + 2] == -1; }

    using OmBytes::throw_bad_file;
    using OmBytes::throw_other_fault;

   private:
    void read_header();
    /// Reads the next chunk; returns false at the end of the file.
    bool read_chunk();
    void read_positions();
    std::vector<std::int64_t> read_handles(std::size_t count, std::size_t width);
    void read_property();
    std::size_t next(std::size_t h) const { return checked(halfedges_[3 * h], n_halfedges_); }
    void require_connectivity() const;

    bool has_triangles_ = false;
    std::size_t n_vertices_ = 0;
    std::size_t n_faces_ = 0;
    std::size_t n_halfedges_ = 0;
    std::vector<std::array<double, 3>> points_;
    /// For each halfedge: the next halfedge, the vertex that it points to, and its face or -1.
    std::vector<std::int64_t> halfedges_;
    std::vector<std::int64_t> face_halfedge_;
    std::vector<std::int64_t> vertex_halfedge_;
    std::map<std::string_view, std::string_view> properties_;
};

}  // namespace pcvt
