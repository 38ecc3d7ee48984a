#include "io/gltf/space_gltf.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "io/bytes/json_writer.hpp"
#include "io/forms/lattice_numbers.hpp"
#include "io/forms/material_words.hpp"
#include "io/forms/space_surface.hpp"
#include "io/gltf/gltf_document.hpp"
#include "io/gltf/gltf_writer.hpp"
#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/choices.hpp"
#include "mesher/cells/phase_fractions.hpp"

namespace pcvt {
namespace {

/// The words of kinds stand in the JSON chunk, before the numbers.
constexpr std::string_view kGlbCellsMark = R"("kind":"polyhedra")";
constexpr std::string_view kGlbBoundaryMark = R"("kind":"boundary")";

template <class Value>
GltfExtra extra(const char* key, const Value& value) {
    GltfExtra member{.key = key, .json = {}};
    JsonWriter(member.json, kCompactJson).value(value);
    return member;
}

void add_materials(const CellMaterials& materials, std::vector<GltfExtra>& extras) {
    if (!materials.site_phase.empty()) {
        extras.push_back(extra("phases", materials.phase_names));
        extras.push_back(extra("sitePhases", materials.site_phase));
    }
    if (materials.site_orientation.empty()) return;
    std::vector<std::array<double, 3>> angles;
    for (const BungeAngles& own : materials.site_orientation) {
        angles.push_back({own.phi1, own.Phi, own.phi2});
    }
    extras.push_back(extra("orientations", angles));
}

/// Makes one group of all faces, in the order of their colours.
void join_groups(SurfaceMesh& mesh, const char* name) {
    std::vector<int> order(mesh.face_class.size());
    std::iota(order.begin(), order.end(), 0);
    cancellable_stable_sort(order.begin(), order.end(),
                            [&](int f, int g) { return mesh.face_class[f] < mesh.face_class[g]; });
    Faces faces;
    for (const int f : order) faces.add(mesh.faces[f]);
    mesh.faces = std::move(faces);
    std::sort(mesh.face_class.begin(), mesh.face_class.end());
    mesh.groups = {{name, 0}};
}

/// Reads one document.
class GlbParser {
   public:
    explicit GlbParser(const EncodedFile& glb) : document_(glb) {}

    GlbSurfaces parse() && {
        const Json& tile = document_.entry("nodes", 0);
        const Json& periodic = GltfDocument::periodic(tile);
        if (GltfDocument::member(periodic, "kind") == "boundary") {
            glb_.list.form = SurfaceForm::kBoundary;
        }
        surface_.lattice = lattice(vectors(periodic, "lattice"));
        surface_.sites = vectors(periodic, "sites");
        take_colouring(periodic);
        take_weights(periodic);
        take_materials(periodic);
        for (const Json& child : GltfDocument::member(tile, "children")) {
            checkpoint();
            add_node(document_.entry("nodes", document_.count(child, "children")));
        }
        if (glb_.groups.empty()) document_.throw_bad_file("has no surface; give the whole file");
        return std::move(glb_);
    }

   private:
    void take_colouring(const Json& periodic) {
        const Json& word = GltfDocument::member(periodic, "colouring");
        if (word.is_null()) return;
        const ColouringRow* const row =
            word.is_string() ? find_word(kColourings, word.text()) : nullptr;
        if (row == nullptr || !row->in_space) {
            document_.throw_bad_file("pcvt does not know extras.periodic.colouring");
        }
        glb_.list.colouring = row->colouring;
    }

    void take_weights(const Json& periodic) {
        const Json& weights = GltfDocument::member(periodic, "weights");
        if (weights.is_null()) return;
        const auto n = static_cast<std::size_t>(surface_.sites.cols());
        const std::vector<double> numbers = GltfDocument::number_list(weights, n);
        if (n == 0 || numbers.size() != n) {
            document_.throw_bad_file("extras.periodic.weights is not one number for each site");
        }
        glb_.list.weights = Eigen::Map<const Eigen::VectorXd>(numbers.data(), std::ssize(numbers));
    }

    void take_materials(const Json& periodic) {
        CellMaterials& materials = glb_.list.materials;
        for (const Json& name : GltfDocument::member(periodic, "phases")) {
            materials.phase_names.push_back(name.is_string() ? name.text() : "");
        }
        for (const Json& phase : GltfDocument::member(periodic, "sitePhases")) {
            const std::size_t k = document_.count(phase, "sitePhases");
            if (k >= materials.phase_names.size()) {
                document_.throw_bad_file(
                    "extras.periodic.sitePhases names a phase that is missing");
            }
            materials.site_phase.push_back(static_cast<int>(k));
        }
        const space::Points angles = vectors(periodic, "orientations");
        try {
            if (!materials.phase_names.empty()) require_phase_names(materials.phase_names);
            for (Eigen::Index s = 0; s < angles.cols(); ++s) {
                materials.site_orientation.push_back(
                    checked_angles({angles(0, s), angles(1, s), angles(2, s)}));
            }
        } catch (const InvalidInput& fault) {
            document_.throw_bad_file(std::string("extras.periodic: ") + fault.what());
        }
        require_materials(document_.path(), materials, surface_.sites.cols());
        require_shown_materials(glb_.list, document_.path());
    }

    /// @returns one vector a column.
    space::Points vectors(const Json& periodic, const char* key) const {
        const Json& rows = GltfDocument::member(periodic, key);
        const std::vector<double> numbers = GltfDocument::vector_list(rows, 3);
        if (numbers.size() != 3 * rows.size()) {
            document_.throw_bad_file("extras.periodic." + std::string(key) +
                                     " is not a list of vectors; write it again with pcvt");
        }
        return Eigen::Map<const space::Points>(numbers.data(), 3,
                                               static_cast<Eigen::Index>(rows.size()));
    }

    space::Lattice lattice(const space::Points& periods) const {
        if (periods.cols() != 3) {
            document_.throw_bad_file("extras.periodic.lattice is not [a, b, c]; write it again");
        }
        try {
            return {periods.col(0), periods.col(1), periods.col(2)};
        } catch (const InvalidInput& fault) {
            document_.throw_bad_file(fault.what());
        }
    }

    void add_node(const Json& node) {
        const Json& name = GltfDocument::member(node, "name");
        const Json& mesh = document_.entry("meshes", document_.count_in(node, "mesh"));
        for (const Json& primitive : GltfDocument::member(mesh, "primitives")) {
            glb_.groups.push_back(
                {name.is_string() ? std::string(name.text()) : "", surface_.n_faces()});
            const auto first = static_cast<int>(surface_.points.size());
            const int n_points = add_points(GltfDocument::member(primitive, "attributes"));
            add_fans(document_.indices(document_.count_in(primitive, "indices"),
                                       static_cast<std::size_t>(n_points)),
                     first);
            if (glb_.list.colouring == Colouring::kCells) {
                glb_.list.cell_class.push_back(cell_class(document_.material_name(primitive)));
            }
            const auto n_faces = static_cast<std::size_t>(surface_.n_faces());
            surface_.cell.resize(n_faces, static_cast<SiteId>(glb_.groups.size()) - 1);
            if (glb_.list.form == SurfaceForm::kBoundary) {
                const std::vector<int> offset = offset_in_name(glb_.groups.back().name);
                surface_.offset.resize(n_faces, offset.size() == 3
                                                    ? space::Offset{offset[0], offset[1], offset[2]}
                                                    : space::Offset{});
            }
        }
    }

    /// The number of a colour of cells, by the name of its material.
    int cell_class(const std::string& material) const {
        const std::vector<ColourClass> classes = cell_classes({}).classes;
        const auto found = std::find_if(classes.begin(), classes.end(),
                                        [&](const ColourClass& c) { return c.name == material; });
        if (found != classes.end()) return static_cast<int>(found - classes.begin());
        document_.throw_bad_file("a primitive has not the material of a colour of cells");
    }

    /// @returns the number of points.
    int add_points(const Json& attributes) {
        const std::vector<float> points =
            document_.floats(document_.count_in(attributes, "POSITION"), 3);
        const std::vector<float> normals =
            document_.floats(document_.count_in(attributes, "NORMAL"), 3);
        if (normals.size() != points.size()) {
            document_.throw_bad_file("a primitive has not one normal for each vertex");
        }
        for (std::size_t k = 0; k < points.size(); k += 3) {
            surface_.points.emplace_back(points[k], points[k + 1], points[k + 2]);
            glb_.normals.push_back({normals[k], normals[k + 1], normals[k + 2]});
        }
        return static_cast<int>(points.size() / 3);
    }

    /// Adds triangles as faces. One that continues the fan before it becomes part of its face.
    void add_fans(const std::vector<int>& indices, int first) {
        if (indices.empty() || indices.size() % 3 != 0) {
            document_.throw_bad_file("a primitive does not consist of triangles");
        }
        std::vector<int> face;
        for (std::size_t k = 0; k < indices.size(); k += 3) {
            const int a = first + indices[k];
            const int b = first + indices[k + 1];
            if (face.empty() || face.front() != a || face.back() != b) {
                if (!face.empty()) surface_.faces.add(face);
                face = {a, b};
            }
            face.push_back(first + indices[k + 2]);
        }
        surface_.faces.add(face);
    }

    GltfDocument document_;
    GlbSurfaces glb_;
    space::TileSurface& surface_ = glb_.list.surface;
};

}  // namespace

GltfSurface gltf_surface(SurfaceList list) {
    const space::TileSurface& surface = list.surface;
    const bool is_boundary = list.form == SurfaceForm::kBoundary;
    GltfSurface result;
    result.extras = {extra("kind", is_boundary ? "boundary" : "polyhedra"),
                     extra("lattice", surface.lattice.periods())};
    if (surface.sites.cols() > 0) {
        result.extras.push_back(extra("sites", surface.sites.colwise()));
    }
    if (list.weights.size() > 0) {
        result.extras.push_back(
            extra("weights", std::vector<double>(list.weights.begin(), list.weights.end())));
    }
    if (list.colouring != Colouring::kFaces) {
        result.extras.push_back(extra("colouring", colouring_row(list.colouring).word));
    }
    add_materials(list.materials, result.extras);
    result.mesh = surface_mesh(std::move(list), SeamForm::kNone);
    if (result.mesh.groups.size() > std::size_t{kMaxCellNodes}) {
        join_groups(result.mesh, is_boundary ? "boundary" : "cells");
    }
    return result;
}

std::vector<EncodedFile> encode_glb_surfaces(SurfaceList list, const std::string& path) {
    return encode_gltf_surface(gltf_surface(std::move(list)), path, GltfContainer::kBinary);
}

bool holds_glb_surfaces(const EncodedFile& file) {
    std::string_view json = file.bytes;
    if (!json.starts_with("glTF")) return false;
    json = json.substr(0, json.find(std::string_view("BIN\0", 4)));
    return json.find(kGlbCellsMark) != std::string_view::npos ||
           json.find(kGlbBoundaryMark) != std::string_view::npos;
}

GlbSurfaces decode_glb_surfaces(const EncodedFile& glb) { return GlbParser(glb).parse(); }

}  // namespace pcvt
