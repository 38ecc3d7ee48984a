#include "io/gltf/gltf_writer.hpp"

#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

#include "io/bytes/json_writer.hpp"
#include "io/bytes/output_error.hpp"
#include "io/gltf/gltf_model_builder.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

using Primitives = std::vector<tinygltf::Primitive>;

constexpr float kLift = 0.002F;
constexpr Colour kLineColour{0.16, 0.17, 0.20};

Point3 narrow(const Eigen::Vector3d& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

std::vector<Point3> narrow_points(const SurfaceMesh& mesh) {
    std::vector<Point3> points;
    points.reserve(mesh.points.size());
    for (const Eigen::Vector3d& p : mesh.points) points.push_back(narrow(p));
    return points;
}

/// The unit normal of a polygon, from its area vector.
Eigen::Vector3d normal_of(const std::vector<Eigen::Vector3d>& points,
                          std::span<const int> corners) {
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t k = 2; k < corners.size(); ++k) {
        area += (points[corners[k - 1]] - points[corners[0]])
                    .cross(points[corners[k]] - points[corners[0]]);
    }
    return area.stableNormalized();
}

/// Returns the colour of each point as linear light.
std::vector<Point3> lights(const SurfaceMesh& mesh) {
    std::vector<Point3> light_of;
    for (const ColourClass& shown : mesh.classes) {
        const Colour light = linear(shown.colour);
        light_of.push_back(narrow({light.r, light.g, light.b}));
    }
    std::vector<Point3> result;
    result.reserve(mesh.vertex_class.size());
    for (const int k : mesh.vertex_class) result.push_back(light_of[k]);
    return result;
}

/// The first face of each primitive, which has one colour and belongs to one group; the end
/// follows.
std::vector<int> primitive_begins(const SurfaceMesh& mesh) {
    std::vector<int> begins;
    std::size_t group = 0;
    for (int f = 0; f < mesh.faces.n_faces(); ++f) {
        const bool begins_group = group < mesh.groups.size() && mesh.groups[group].first_face == f;
        if (begins_group) ++group;
        if (begins_group || mesh.face_class[f] != mesh.face_class[f - 1]) begins.push_back(f);
    }
    begins.push_back(mesh.faces.n_faces());
    return begins;
}

/// The faces from `face` to `end`, with points of their own.
tinygltf::Primitive flat_primitive(const SurfaceMesh& mesh, int face, int end,
                                   ModelBuilder& builder) {
    std::vector<Point3> points;
    std::vector<Point3> normals;
    std::vector<int> indices;
    for (; face < end; ++face) {
        const auto corners = mesh.faces[face];
        const auto first = static_cast<int>(points.size());
        for (const int v : corners) points.push_back(narrow(mesh.points[v]));
        normals.resize(points.size(), narrow(normal_of(mesh.points, corners)));
        for (int k = 2; k < static_cast<int>(corners.size()); ++k) {
            indices.insert(indices.end(), {first, first + k - 1, first + k});
        }
    }
    tinygltf::Primitive primitive;
    primitive.attributes["POSITION"] = builder.add_positions(points);
    primitive.attributes["NORMAL"] = builder.add_vertex_data(normals);
    primitive.indices =
        builder.add_indices(indices, {0, static_cast<int>(indices.size())}, points.size());
    return primitive;
}

/// The triangles of a surface, which share their points.
Primitives shared_primitives(const GltfSurface& surface, std::vector<int> begins,
                             ModelBuilder& builder) {
    const SurfaceMesh& mesh = surface.mesh;
    tinygltf::Primitive primitive;
    auto& attributes = primitive.attributes;
    attributes["POSITION"] = builder.add_positions(narrow_points(mesh));
    attributes["NORMAL"] = builder.add_vertex_data(surface.normals);
    if (!mesh.texture.empty()) attributes["TEXCOORD_0"] = builder.add_vertex_data(mesh.texture);
    if (!mesh.vertex_class.empty()) attributes["COLOR_0"] = builder.add_vertex_data(lights(mesh));
    if (!surface.vertex_site.empty()) {
        const std::vector<float> sites(surface.vertex_site.begin(), surface.vertex_site.end());
        attributes["_SITE_ID"] = builder.add_floats(sites, 1);
    }
    for (int& begin : begins) begin *= 3;
    primitive.indices = builder.add_indices(mesh.faces.corners, begins, mesh.points.size());
    Primitives primitives;
    for (std::size_t k = 1; k < begins.size(); ++k) {
        primitives.push_back(primitive);
        ++primitive.indices;
    }
    return primitives;
}

void add_nodes(const GltfSurface& surface, ModelBuilder& builder) {
    const SurfaceMesh& mesh = surface.mesh;
    const int n_materials = 1 + *std::max_element(mesh.face_class.begin(), mesh.face_class.end());
    for (int m = 0; m < n_materials; ++m) {
        builder.add_material(mesh.classes[m].name, mesh.classes[m].colour);
    }
    const std::vector<int> begins = primitive_begins(mesh);
    Primitives primitives;
    if (!surface.normals.empty()) primitives = shared_primitives(surface, begins, builder);
    for (std::size_t k = 0, g = 0; g < mesh.groups.size(); ++g) {
        Primitives of_node;
        for (; begins[k] < mesh.group_end(g); ++k) {
            checkpoint();
            of_node.push_back(surface.normals.empty()
                                  ? flat_primitive(mesh, begins[k], begins[k + 1], builder)
                                  : std::move(primitives[k]));
            of_node.back().mode = TINYGLTF_MODE_TRIANGLES;
            of_node.back().material = mesh.face_class[begins[k]];
        }
        builder.add_node(mesh.groups[g].name, std::move(of_node));
    }
}

void add_lines(const GltfSurface& surface, ModelBuilder& builder) {
    std::vector<Point3> points = narrow_points(surface.mesh);
    // Lift the lines above the surface.
    float size = 0;
    for (const std::size_t k : {0, 1}) {
        const auto less = [k](const Point3& p, const Point3& q) { return p[k] < q[k]; };
        const auto [least, most] = std::minmax_element(points.begin(), points.end(), less);
        size = std::max(size, (*most)[k] - (*least)[k]);
    }
    for (Point3& p : points) p[2] += kLift * size;
    checkpoint();
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_LINE;
    primitive.attributes["POSITION"] = builder.add_positions(points);
    primitive.indices = builder.add_indices(
        surface.lines, {0, static_cast<int>(surface.lines.size())}, points.size());
    primitive.material = builder.add_unlit_material("outlines", kLineColour);
    builder.add_node("outlines", {std::move(primitive)});
}

/// Returns extras.periodic as JSON. A tinygltf::Value would take 150 bytes per number.
std::string extras_json(const std::vector<GltfExtra>& extras, ModelBuilder& builder) {
    std::string text;
    JsonWriter json(text, kCompactJson);
    json.begin_object();
    for (const GltfExtra& extra : extras) {
        json.key(extra.key);
        if (extra.numbers.empty()) {
            json.raw(extra.json);
        } else {
            json.value(builder.add_floats(extra.numbers, extra.width));
        }
    }
    json.end();
    return text;
}

void require_range(const SurfaceMesh& mesh, const std::string& path) {
    for (const Eigen::Vector3d& p : mesh.points) {
        if (p.cwiseAbs().maxCoeff() < double(std::numeric_limits<float>::max())) continue;
        throw CoarsePrecision(path +
                              ": a coordinate is too large for the single precision of glTF; take "
                              "another unit of length");
    }
}

/// About the size of the buffer.
std::size_t buffer_bytes(const GltfSurface& surface) {
    const std::size_t n_corners = surface.mesh.faces.corners.size();
    if (surface.normals.empty()) return n_corners * (2 * sizeof(Point3) + 3 * sizeof(int));
    std::size_t n_floats = 9 * surface.mesh.points.size() + surface.mesh.vertex_class.size() * 3 +
                           2 * surface.mesh.texture.size() + surface.vertex_site.size();
    for (const GltfExtra& extra : surface.extras) n_floats += extra.numbers.size();
    return n_floats * sizeof(float) + (n_corners + surface.lines.size()) * sizeof(int);
}

}  // namespace

std::vector<EncodedFile> encode_gltf_surface(const GltfSurface& surface, const std::string& path,
                                             GltfContainer container) {
    require_range(surface.mesh, path);
    const std::size_t n_bytes = buffer_bytes(surface);
    require_gltf_size(n_bytes, path);
    ModelBuilder builder(n_bytes, surface.translation);
    add_nodes(surface, builder);
    if (!surface.lines.empty()) add_lines(surface, builder);
    const std::string extras = extras_json(surface.extras, builder);
    return std::move(builder).encode(path, extras, container);
}

}  // namespace pcvt
