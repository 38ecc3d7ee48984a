#include "io/surfaces/surface_glb_writer.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <utility>

#include "io/bytes/json.hpp"
#include "io/bytes/output_error.hpp"
#include "io/bytes/text.hpp"
#include "io/gltf/gltf_container.hpp"
#include "io/gltf/gltf_json.hpp"
#include "io/gltf/gltf_model_builder.hpp"
#include "io/gltf/gltf_writer.hpp"
#include "io/surfaces/surface_parts.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

/// tinygltf stores offsets as int.
constexpr std::size_t kMostBytes = std::numeric_limits<int>::max();

void append_json_vector(std::string& text, const space::Vec3& vector) {
    char before = '[';
    for (const double x : vector) {
        text += before;
        append_number(text, x);
        before = ',';
    }
    text += ']';
}

std::string periodic_json(const SurfaceList& list) {
    const bool is_boundary = list.form == SurfaceForm::kBoundary;
    std::string text =
        is_boundary ? R"({"kind":"boundary","lattice":[)" : R"({"kind":"polyhedra","lattice":[)";
    for (const space::Vec3& period : list.lattice.periods()) {
        append_json_vector(text, period);
        text += ',';
    }
    text.back() = ']';
    if (list.sites.cols() == 0) return text + '}';
    text += ",\"sites\":[";
    for (const auto& site : list.sites.colwise()) {
        append_json_vector(text, site);
        text += ',';
    }
    text.back() = ']';
    return text + '}';
}

/// The unit normal of a polygon, from its area vector.
space::Vec3 normal_of(const std::vector<space::Vec3>& points, std::span<const int> corners) {
    space::Vec3 area = space::Vec3::Zero();
    for (std::size_t k = 2; k < corners.size(); ++k) {
        area += (points[corners[k - 1]] - points[corners[0]])
                    .cross(points[corners[k]] - points[corners[0]]);
    }
    return area.stableNormalized();
}

Point3 narrow(const space::Vec3& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/// Triangles of a part, whose faces share no vertices.
struct PartTriangles {
    std::vector<Point3> points;
    std::vector<Point3> normals;
    std::vector<int> indices;
};

void append_faces(const SurfaceList& list, const SurfacePart& part, PartTriangles& triangles) {
    for (int f = part.first_face; f < part.first_face + part.n_faces; ++f) {
        const auto corners = list.faces[f];
        const auto first = static_cast<int>(triangles.points.size());
        const Point3 normal = narrow(normal_of(list.points, corners));
        for (const int v : corners) {
            triangles.points.push_back(narrow(list.points[v]));
            triangles.normals.push_back(normal);
        }
        for (int k = 2; k < static_cast<int>(corners.size()); ++k) {
            triangles.indices.insert(triangles.indices.end(), {first, first + k - 1, first + k});
        }
    }
}

tinygltf::Primitive add_primitive(const PartTriangles& triangles, int material,
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

/// One node for each part.
void add_nodes(const SurfaceList& list, const SurfaceParts& parts, ModelBuilder& builder) {
    for (const SurfacePart& part : parts.parts) {
        checkpoint();
        PartTriangles triangles;
        append_faces(list, part, triangles);
        std::vector<tinygltf::Primitive> primitives;
        primitives.push_back(add_primitive(triangles, part.colour, builder));
        builder.add_node(part.name, std::move(primitives));
    }
}

/// One node, with a primitive for each colour.
void add_one_node(const SurfaceList& list, const SurfaceParts& parts, ModelBuilder& builder) {
    std::vector<PartTriangles> of_class(parts.classes.size());
    for (const SurfacePart& part : parts.parts) {
        checkpoint();
        append_faces(list, part, of_class[part.colour]);
    }
    std::vector<tinygltf::Primitive> primitives;
    for (std::size_t k = 0; k < of_class.size(); ++k) {
        primitives.push_back(add_primitive(of_class[k], static_cast<int>(k), builder));
    }
    builder.add_node(list.form == SurfaceForm::kCells ? "cells" : "boundary",
                     std::move(primitives));
}

void require_range(const SurfaceList& list, const std::string& path) {
    for (const space::Vec3& p : list.points) {
        if (p.cwiseAbs().maxCoeff() < double(std::numeric_limits<float>::max())) continue;
        throw CoarsePrecision(path +
                              ": a coordinate is too large for the single precision of glTF; take "
                              "another unit of length");
    }
}

}  // namespace

std::vector<EncodedFile> encode_surface_glb(const SurfaceList& list, const std::string& path) {
    require_range(list, path);
    const SurfaceParts parts = surface_parts(list);
    const std::size_t n_corners = list.faces.corners.size();
    const std::size_t n_bytes = n_corners * (2 * sizeof(Point3) + 3 * sizeof(int));
    if (n_bytes > kMostBytes) {
        throw LimitExceeded(path + ": more than 2 GiB, too large for glTF; write another format");
    }
    ModelBuilder builder(n_bytes);
    for (const ColourClass& shown : parts.classes) builder.add_material(shown.name, shown.colour);
    if (static_cast<int>(parts.parts.size()) <= kMaxCellNodes) {
        add_nodes(list, parts, builder);
    } else {
        add_one_node(list, parts, builder);
    }
    const std::vector<unsigned char> buffer = std::move(builder.model().buffers[0].data);
    return only_file(
        path, glb_bytes(gltf_json(builder.model(), periodic_json(list), buffer, false), buffer));
}

}  // namespace pcvt
