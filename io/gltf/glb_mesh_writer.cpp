#include "io/gltf/glb_mesh_writer.hpp"

#include <Eigen/Geometry>
#include <limits>
#include <utility>

#include "io/bytes/output_error.hpp"
#include "io/bytes/text.hpp"
#include "io/gltf/gltf_model_builder.hpp"
#include "io/gltf/gltf_writer.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// Appends numbers as a list of vectors.
void append_vectors(std::string& text, const std::vector<double>& numbers) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        text += k == 0 ? "[[" : k % 3 == 0 ? "],[" : ",";
        append_number(text, numbers[k]);
    }
    text += "]]";
}

std::string periodic_json(const SurfaceMesh& mesh) {
    std::string text = R"({"kind":")" + mesh.kind + '"';
    for (const NoteTable& note : mesh.notes) {
        if (note.reals().empty()) continue;
        text += note.of == NoteOf::kSites ? R"(,"sites":)" : R"(,"lattice":)";
        append_vectors(text, note.reals());
    }
    return text + '}';
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

Point3 narrow(const Eigen::Vector3d& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/// Triangles of a group, whose faces share no vertices.
struct GroupTriangles {
    std::vector<Point3> points;
    std::vector<Point3> normals;
    std::vector<int> indices;
};

void append_group(const SurfaceMesh& mesh, std::size_t group, GroupTriangles& triangles) {
    for (int f = mesh.groups[group].first_face; f < mesh.group_end(group); ++f) {
        const auto corners = mesh.faces[f];
        const auto first = static_cast<int>(triangles.points.size());
        const Point3 normal = narrow(normal_of(mesh.points, corners));
        for (const int v : corners) {
            triangles.points.push_back(narrow(mesh.points[v]));
            triangles.normals.push_back(normal);
        }
        for (int k = 2; k < static_cast<int>(corners.size()); ++k) {
            triangles.indices.insert(triangles.indices.end(), {first, first + k - 1, first + k});
        }
    }
}

tinygltf::Primitive add_primitive(const GroupTriangles& triangles, int material,
                                  ModelBuilder& builder) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = builder.add_positions(triangles.points);
    primitive.attributes["NORMAL"] = builder.add_vertex_data(triangles.normals, TINYGLTF_TYPE_VEC3);
    primitive.indices =
        builder.add_indices(triangles.indices, {0, static_cast<int>(triangles.indices.size())},
                            triangles.points.size());
    primitive.material = material;
    return primitive;
}

int colour_of(const SurfaceMesh& mesh, std::size_t group) {
    return mesh.face_class[mesh.groups[group].first_face];
}

/// One node for each group.
void add_nodes(const SurfaceMesh& mesh, ModelBuilder& builder) {
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        checkpoint();
        GroupTriangles triangles;
        append_group(mesh, g, triangles);
        std::vector<tinygltf::Primitive> primitives;
        primitives.push_back(add_primitive(triangles, colour_of(mesh, g), builder));
        builder.add_node(mesh.groups[g].name, std::move(primitives));
    }
}

/// One node, with a primitive for each colour.
void add_one_node(const SurfaceMesh& mesh, ModelBuilder& builder) {
    std::vector<GroupTriangles> of_class(mesh.classes.size());
    for (std::size_t g = 0; g < mesh.groups.size(); ++g) {
        checkpoint();
        append_group(mesh, g, of_class[colour_of(mesh, g)]);
    }
    std::vector<tinygltf::Primitive> primitives;
    for (std::size_t k = 0; k < of_class.size(); ++k) {
        primitives.push_back(add_primitive(of_class[k], static_cast<int>(k), builder));
    }
    builder.add_node(mesh.kind == "boundary" ? "boundary" : "cells", std::move(primitives));
}

void require_range(const SurfaceMesh& mesh, const std::string& path) {
    for (const Eigen::Vector3d& p : mesh.points) {
        if (p.cwiseAbs().maxCoeff() < double(std::numeric_limits<float>::max())) continue;
        throw CoarsePrecision(path +
                              ": a coordinate is too large for the single precision of glTF; take "
                              "another unit of length");
    }
}

}  // namespace

std::vector<EncodedFile> encode_glb_mesh(const SurfaceMesh& mesh, const std::string& path) {
    require_range(mesh, path);
    const std::size_t n_corners = mesh.faces.corners.size();
    const std::size_t n_bytes = n_corners * (2 * sizeof(Point3) + 3 * sizeof(int));
    require_gltf_size(n_bytes, path);
    ModelBuilder builder(n_bytes);
    for (const ColourClass& shown : mesh.classes) builder.add_material(shown.name, shown.colour);
    if (static_cast<int>(mesh.groups.size()) <= kMaxCellNodes) {
        add_nodes(mesh, builder);
    } else {
        add_one_node(mesh, builder);
    }
    return std::move(builder).encode(path, periodic_json(mesh), GltfContainer::kBinary);
}

}  // namespace pcvt
