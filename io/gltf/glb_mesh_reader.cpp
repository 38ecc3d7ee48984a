#include "io/gltf/glb_mesh_reader.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "io/gltf/gltf_document.hpp"
#include "io/gltf/gltf_writer.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/law_violation.hpp"

namespace pcvt {
namespace {

using Corner = std::array<float, 3>;

/// The words of kinds stand in the JSON chunk, before the numbers.
constexpr std::string_view kGlbCellsMark = R"("kind":"polyhedra")";
constexpr std::string_view kGlbBoundaryMark = R"("kind":"boundary")";

/// The JSON chunk of a GLB; empty if there is none.
std::string_view json_chunk(std::string_view bytes) {
    constexpr std::size_t kHead = 20;
    if (bytes.size() < kHead || !bytes.starts_with("glTF")) return {};
    std::size_t length = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        length |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[12 + k])) << (8 * k);
    }
    return bytes.substr(kHead, length);
}

/// Reads one document.
class GlbParser {
   public:
    explicit GlbParser(const EncodedFile& glb) : document_(glb) {}

    GlbSurfaces parse() {
        const Json& tile = document_.entry("nodes", 0);
        const Json& periodic =
            GltfDocument::member(GltfDocument::member(tile, "extras"), "periodic");
        GlbSurfaces glb;
        if (GltfDocument::member(periodic, "kind") == "boundary") {
            glb.form = SurfaceForm::kBoundary;
        }
        glb.lattice = lattice(GltfDocument::member(periodic, "lattice"));
        const std::vector<space::Vec3> sites =
            vectors(GltfDocument::member(periodic, "sites"), "sites");
        glb.sites.resize(3, static_cast<Eigen::Index>(sites.size()));
        for (std::size_t s = 0; s < sites.size(); ++s) {
            glb.sites.col(static_cast<Eigen::Index>(s)) = sites[s];
        }
        for (const Json& child : GltfDocument::member(tile, "children")) {
            checkpoint();
            add_node(document_.entry("nodes", document_.count(child, "children")), glb.parts);
        }
        if (glb.parts.empty()) document_.throw_bad_file("has no surface; give the whole file");
        return glb;
    }

   private:
    std::vector<space::Vec3> vectors(const Json& rows, const std::string& name) const {
        std::vector<space::Vec3> result;
        for (const Json& row : rows) {
            const bool is_vector = row.is_array() && row.size() == 3 && row[0].is_number() &&
                                   row[1].is_number() && row[2].is_number();
            if (!is_vector) {
                document_.throw_bad_file("extras.periodic." + name +
                                         " is not a list of vectors; write it again with pcvt");
            }
            result.emplace_back(row[0].get<double>(), row[1].get<double>(), row[2].get<double>());
        }
        return result;
    }

    space::Lattice lattice(const Json& rows) const {
        const std::vector<space::Vec3> periods = vectors(rows, "lattice");
        if (periods.size() != 3) {
            document_.throw_bad_file("extras.periodic.lattice is not [a, b, c]; write it again");
        }
        try {
            return {periods[0], periods[1], periods[2]};
        } catch (const InvalidInput& fault) {
            document_.throw_bad_file(fault.what());
        }
    }

    static std::vector<Corner> corners_of(const std::vector<float>& numbers) {
        std::vector<Corner> corners;
        for (std::size_t k = 0; k < numbers.size(); k += 3) {
            corners.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
        }
        return corners;
    }

    void add_node(const Json& node, std::vector<GlbPart>& parts) const {
        const Json& name = GltfDocument::member(node, "name");
        const Json& mesh = document_.entry("meshes", document_.count_in(node, "mesh"));
        for (const Json& primitive : GltfDocument::member(mesh, "primitives")) {
            GlbPart& part = parts.emplace_back();
            part.name = name.is_string() ? name.text() : "";
            const Json& attributes = GltfDocument::member(primitive, "attributes");
            const std::vector<float> points =
                document_.floats(document_.count_in(attributes, "POSITION"), 3);
            part.normals =
                corners_of(document_.floats(document_.count_in(attributes, "NORMAL"), 3));
            if (3 * part.normals.size() != points.size()) {
                document_.throw_bad_file("a primitive has not one normal for each vertex");
            }
            part.vertices =
                document_.indices(document_.count_in(primitive, "indices"), points.size() / 3);
            for (const int v : part.vertices) {
                const std::size_t at = 3 * static_cast<std::size_t>(v);
                part.corners.push_back({points[at], points[at + 1], points[at + 2]});
            }
            if (part.corners.empty() || part.corners.size() % 3 != 0) {
                document_.throw_bad_file("a primitive does not consist of triangles");
            }
        }
    }

    GltfDocument document_;
};

space::Vec3 widened(const Corner& corner) { return {corner[0], corner[1], corner[2]}; }

/// An edge from its lower end to its higher one, and its sense: 1, or -1 for the reverse.
struct Edge {
    Corner low;
    Corner high;
    int sense;
};

void append_edges(const GlbPart& part, std::vector<Edge>& edges) {
    for (std::size_t c = 0; c < part.corners.size(); ++c) {
        const Corner& from = part.corners[c];
        const Corner& to = part.corners[c % 3 == 2 ? c - 2 : c + 1];
        // Rounding may bring two corners together.
        if (from == to) continue;
        edges.push_back(from < to ? Edge{from, to, 1} : Edge{to, from, -1});
    }
}

void require_closed(std::vector<Edge> edges, const std::string& name) {
    std::sort(edges.begin(), edges.end(), [](const Edge& s, const Edge& t) {
        return std::tie(s.low, s.high) < std::tie(t.low, t.high);
    });
    for (std::size_t k = 0; k < edges.size();) {
        checkpoint_each(static_cast<long>(k));
        int sum = 0;
        std::size_t end = k;
        while (end < edges.size() && edges[end].low == edges[k].low &&
               edges[end].high == edges[k].high) {
            sum += edges[end++].sense;
        }
        if (sum != 0) throw_violation("(1), closed surfaces", name + " does not close");
        k = end;
    }
}

/// The volume and the area of triangles; the volume is that of the cones over them at a point.
struct Extent {
    double volume = 0;
    double area = 0;
};

Extent extent_of(const GlbPart& part, const space::Vec3& origin) {
    Extent extent;
    for (std::size_t c = 0; c < part.corners.size(); c += 3) {
        const space::Vec3 p = widened(part.corners[c]) - origin;
        const space::Vec3 q = widened(part.corners[c + 1]) - origin;
        const space::Vec3 r = widened(part.corners[c + 2]) - origin;
        extent.volume += p.cross(q).dot(r) / 6;
        extent.area += (q - p).cross(r - p).norm() / 2;
    }
    return extent;
}

using Triangle = std::array<Corner, 3>;

std::vector<Triangle> sorted_triangles(const GlbSurfaces& glb) {
    std::vector<Triangle> triangles;
    for (const GlbPart& part : glb.parts) {
        for (std::size_t c = 0; c < part.corners.size(); c += 3) {
            triangles.push_back({part.corners[c], part.corners[c + 1], part.corners[c + 2]});
        }
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

/// The fans of the faces, in single precision.
std::vector<Triangle> sorted_triangles(const SurfaceMesh& mesh) {
    const auto corner = [&](int v) {
        const Eigen::Vector3f p = mesh.points[v].cast<float>();
        return Corner{p.x(), p.y(), p.z()};
    };
    std::vector<Triangle> triangles;
    for (int f = 0; f < mesh.faces.n_faces(); ++f) {
        const auto face = mesh.faces[f];
        for (std::size_t k = 2; k < face.size(); ++k) {
            triangles.push_back({corner(face[0]), corner(face[k - 1]), corner(face[k])});
        }
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

}  // namespace

bool holds_glb_surfaces(const EncodedFile& file) {
    const std::string_view json = json_chunk(file.bytes);
    return json.find(kGlbCellsMark) != std::string_view::npos ||
           json.find(kGlbBoundaryMark) != std::string_view::npos;
}

GlbSurfaces decode_glb_surfaces(const EncodedFile& glb) { return GlbParser(glb).parse(); }

void require_same_surfaces(const GlbSurfaces& glb, const SurfaceMesh& mesh) {
    if (sorted_triangles(glb) != sorted_triangles(mesh)) {
        throw NotATile("the triangles are not those of the faces");
    }
    if (mesh.groups.size() > static_cast<std::size_t>(kMaxCellNodes)) return;
    const bool same_names = std::equal(
        glb.parts.begin(), glb.parts.end(), mesh.groups.begin(), mesh.groups.end(),
        [](const GlbPart& found, const FaceGroup& group) { return found.name == group.name; });
    if (!same_names) throw NotATile("the nodes are not the parts of the surface");
}

bool fits_single_precision(const SurfaceMesh& mesh) {
    constexpr double kResolved = 4e3;
    double largest = 0;
    for (const space::Vec3& p : mesh.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    double smallest = std::numeric_limits<double>::infinity();
    for (int f = 0; f < mesh.faces.n_faces(); ++f) {
        checkpoint_each(f);
        const auto face = mesh.faces[f];
        const space::Vec3& first = mesh.points[face.front()];
        space::Vec3 from = mesh.points[face.back()];
        space::Vec3 area = space::Vec3::Zero();
        double perimeter = 0;
        for (const int v : face) {
            const space::Vec3& to = mesh.points[v];
            area += (from - first).cross(to - first) / 2;
            perimeter += (to - from).norm();
            smallest = std::min(smallest, (to - from).norm());
            from = to;
        }
        // A face is nowhere longer than half of its perimeter.
        smallest = std::min(smallest, area.norm() / (perimeter / 2));
    }
    return kResolved * double(std::numeric_limits<float>::epsilon()) * largest <= smallest;
}

GlbProof prove_glb_surfaces(const GlbSurfaces& glb) {
    const bool is_boundary = glb.form == SurfaceForm::kBoundary;
    GlbProof proof{.n_parts = static_cast<int>(glb.parts.size())};
    std::vector<Edge> boundary;
    const space::Vec3 origin = widened(glb.parts.front().corners.front());
    double largest = 0;
    double area = 0;
    for (const GlbPart& part : glb.parts) {
        proof.n_triangles += static_cast<int>(part.corners.size() / 3);
        for (const Corner& corner : part.corners) {
            largest = std::max(largest, widened(corner).cwiseAbs().maxCoeff());
        }
        const Extent extent = extent_of(part, origin);
        proof.volume += extent.volume;
        area += extent.area;
        append_edges(part, boundary);
        if (is_boundary) continue;
        require_closed(std::exchange(boundary, {}), part.name);
        if (!(extent.volume > 0)) {
            throw_violation("(2), volumes", part.name + " has no positive volume");
        }
    }
    if (is_boundary) require_closed(std::move(boundary), "the boundary");
    // A corner moves by at most half an ulp along each axis.
    proof.tolerance = std::numeric_limits<float>::epsilon() * largest * area;
    const double wanted = glb.lattice.volume();
    if (!(std::abs(proof.volume - wanted) <= proof.tolerance)) {
        throw_violation("(2), volumes", "they sum to " + std::to_string(proof.volume) + ", not " +
                                            std::to_string(wanted));
    }
    return proof;
}

}  // namespace pcvt
