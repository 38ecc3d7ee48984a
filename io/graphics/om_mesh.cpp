#include "io/graphics/om_mesh.hpp"

#include <cmath>

#include "io/forms/tile_file.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// The format of OpenMesh 9, and the chunk headers of each part of our files.
constexpr char kOmVersion = 'B';
constexpr unsigned kPositions = 0x5600;
constexpr unsigned kEnd = 0x001c;
constexpr unsigned kKindMask = 0x01ff;
constexpr unsigned kTopologyOfVertices = 0x00e0;
constexpr unsigned kTopologyOfHalfedges = 0x00f8;
constexpr unsigned kTopologyOfFaces = 0x00e8;
/// Set in the header of a chunk with a name, which holds a property.
constexpr unsigned kIsNamed = 0x0002;

}  // namespace

OmMesh::OmMesh(const std::string& name, std::string_view bytes) : OmBytes(name, bytes) {
    read_header();
    while (read_chunk()) {
    }
    if (!is_at_end()) throw_bad_file("has data after its end");
}

bool OmMesh::has_entries(std::string_view name) const {
    const auto found = properties_.find(name);
    return found != properties_.end() && found->second.size() > 4;
}

void OmMesh::read_header() {
    const std::string_view magic = take(4);
    const bool known = magic.substr(0, 2) == "OM" && (magic[2] == 'P' || magic[2] == 'T');
    if (!known || magic[3] != kOmVersion) throw_bad_file("is not a mesh as OpenMesh 9 writes it");
    has_triangles_ = magic[2] == 'T';
    n_vertices_ = read_count();
    n_faces_ = read_count();
    n_halfedges_ = 2 * read_count();
    if (n_vertices_ == 0 || n_faces_ == 0 || n_halfedges_ == 0) throw_bad_file("holds no face");
}

bool OmMesh::read_chunk() {
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

void OmMesh::read_positions() {
    for (std::size_t v = 0; v < n_vertices_; ++v) {
        checkpoint_each(v);
        const std::string_view bytes = take(24);
        const std::array p{double_of(bytes), double_of(bytes.substr(8)),
                           double_of(bytes.substr(16))};
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
            throw_bad_file("has a vertex that is not finite");
        }
        points_.push_back(p);
    }
}

std::vector<std::int64_t> OmMesh::read_handles(std::size_t count, std::size_t width) {
    std::vector<std::int64_t> handles;
    const std::string_view bytes = take(count * width);
    for (std::size_t k = 0; k < count; ++k) {
        checkpoint_each(k);
        handles.push_back(integer_of(bytes.substr(k * width, width)));
    }
    return handles;
}

void OmMesh::read_property() {
    const std::string_view property = take(read_size(1));
    take(read_size(1));
    properties_[property] = take(read_size(4));
}

std::vector<int> OmMesh::integers(const char* name, std::size_t dimension,
                                  std::size_t count) const {
    const auto found = properties_.find(name);
    if (found == properties_.end()) throw_bad_file(std::string("has no property ") + name);
    const std::string_view bytes = found->second;
    if (bytes.size() != 4 * dimension * count) {
        throw_bad_file(std::string("has too little or too much ") + name);
    }
    std::vector<int> values;
    for (std::size_t k = 0; k < dimension * count; ++k) {
        values.push_back(static_cast<int>(integer_of(bytes.substr(4 * k, 4))));
    }
    return values;
}

std::vector<double> OmMesh::numbers(const char* name) const {
    const auto found = properties_.find(name);
    const std::string_view bytes = found == properties_.end() ? std::string_view() : found->second;
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

std::size_t OmMesh::checked(std::int64_t index, std::size_t count) const {
    if (index < 0 || static_cast<std::size_t>(index) >= count) {
        throw_bad_file("names a vertex or an edge that does not exist");
    }
    return static_cast<std::size_t>(index);
}

int OmMesh::to_vertex(std::size_t h) const {
    return static_cast<int>(checked(halfedges_[3 * h + 1], n_vertices_));
}
void OmMesh::require_connectivity() const {
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

Faces OmMesh::faces() const {
    Faces faces;
    if (points_.empty() || halfedges_.empty() || face_halfedge_.empty()) {
        throw_bad_file("lacks its vertices or its faces");
    }
    require_connectivity();
    for (std::size_t f = 0; f < n_faces_; ++f) {
        checkpoint_each(f);
        const std::size_t first = checked(face_halfedge_[f], n_halfedges_);
        std::size_t h = first;
        do {
            if (halfedges_[3 * h + 2] != static_cast<std::int64_t>(f) ||
                faces.corners.size() == n_halfedges_) {
                throw_bad_file("has a face that does not close");
            }
            faces.corners.push_back(to_vertex(h));
            h = next(h);
        } while (h != first);
        faces.close();
        if (faces.size(static_cast<int>(f)) < 3) throw_bad_file("has a face without three corners");
    }
    return faces;
}

std::vector<int> OmMesh::offsets(const char* name, std::size_t dimension, std::size_t count) const {
    std::vector<int> values = integers(name, dimension, count);
    for (const int k : values) {
        if (k < -kLargestOffset || k > kLargestOffset) throw_bad_file("has an offset beyond 2^28");
    }
    return values;
}

}  // namespace pcvt
