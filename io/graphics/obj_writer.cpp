#include "io/graphics/obj_writer.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <numeric>
#include <set>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/finite.hpp"
#include "io/forms/plane_surface.hpp"
#include "io/graphics/seam_json.hpp"
#include "mesher/base/cancellable_sort.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/plane/tile/texture_coordinates.hpp"

namespace pcvt {
namespace {

/// The longest texts of numbers, with a blank before them: -2147483648 and
/// -2.2250738585072014e-308.
constexpr std::size_t kLongestInteger = 12;
constexpr std::size_t kLongestNumber = 25;
constexpr Colour kTriangleColour{0.8, 0.8, 0.8};

template <class Numbers>
void append_words(std::string& text, const Numbers& numbers) {
    for (const auto number : numbers) {
        text += ' ';
        append_number(text, number);
    }
    text += '\n';
}

/// Returns the colours of the faces, which are materials. Triangles have one.
TileColours material_colours(const plane::Tile& tile, const FileOptions& options) {
    if (faces_have_sites(tile.kind)) {
        const Colouring colouring = options.colouring.value_or(Colouring::kSides);
        return tile_colours(tile, colouring, options.quantities());
    }
    TileColours grey;
    grey.classes.push_back({kTriangleColour, "triangle", ""});
    grey.class_of.assign(static_cast<std::size_t>(tile.n_faces()), 0);
    return grey;
}

/// Returns the tile with its faces in the order `order`.
plane::Tile with_faces_in_order(const plane::Tile& tile, const std::vector<int>& order) {
    plane::Tile sorted = tile;
    sorted.faces = {};
    sorted.face_site.clear();
    sorted.faces.begin.reserve(tile.faces.begin.size());
    sorted.faces.corners.reserve(tile.faces.corners.size());
    sorted.face_site.reserve(tile.face_site.size());
    for (const int f : order) {
        sorted.faces.add(tile.faces[f]);
        if (!tile.face_site.empty()) sorted.face_site.push_back(tile.face_site[f]);
    }
    for (std::vector<plane::Vec2> plane::Tile::*const points :
         {&plane::Tile::site_points, &plane::Tile::grain_site_points}) {
        if ((tile.*points).size() != order.size()) continue;
        for (std::size_t k = 0; k < order.size(); ++k)
            (sorted.*points)[k] = (tile.*points)[order[k]];
    }
    return sorted;
}

/// The memory of the text, or more. Memory that is reserved and not used costs nothing, in contrast
/// to a text that is moved.
std::size_t most_bytes(const SurfaceMesh& mesh) {
    std::size_t n_numbers = 3 * mesh.points.size() + 2 * mesh.texture.size();
    for (const NoteTable& note : mesh.notes) {
        n_numbers += std::visit([](const auto& numbers) { return numbers.size(); }, note.numbers);
    }
    return n_numbers * kLongestNumber +
           (2 * mesh.faces.corners.size() + mesh.faces.begin.size()) * kLongestInteger;
}

void append_faces(std::string& text, const SurfaceMesh& mesh) {
    const bool has_texture = !mesh.texture.empty();
    std::size_t group = 0;
    for (int f = 0; f < mesh.faces.n_faces(); ++f) {
        checkpoint_each(f);
        const int material = mesh.face_class[f];
        const bool begins = group < mesh.groups.size() && mesh.groups[group].first_face == f;
        if (begins) text += "g " + mesh.groups[group++].name + "\n";
        if (begins || f == 0 || material != mesh.face_class[f - 1]) {
            text += "usemtl " + mesh.classes[material].name + "\n";
        }
        text += 'f';
        for (const int v : mesh.faces[f]) {
            text += ' ';
            append_number(text, v + 1);
            if (!has_texture) continue;
            text += '/';
            append_number(text, v + 1);
        }
        text += '\n';
    }
}

std::string obj_text(const SurfaceMesh& mesh, const std::string& material_file) {
    std::string text;
    text.reserve(most_bytes(mesh));
    append_lines(text, "# ", mesh.explanation);
    text += "# pcvt kind " + mesh.kind + "\n";
    for (const NoteTable& note : mesh.notes) append_note(text, "# pcvt ", note, 1);
    append_lines(text, "# pcvt ", mesh.statements);
    text += "mtllib " + material_file + "\n";
    for (const Eigen::Vector3d& p : mesh.points) {
        text += 'v';
        append_words(text, p);
    }
    for (const auto& [u, v] : mesh.texture) {
        text += "vt";
        append_words(text, std::array{double(u), double(v)});
    }
    append_faces(text, mesh);
    return text;
}

std::string mtl_text(const SurfaceMesh& mesh) {
    std::string text = "# Materials of a periodic tile, written by pcvt\n";
    for (const int k : std::set<int>(mesh.face_class.begin(), mesh.face_class.end())) {
        const ColourClass& material = mesh.classes[k];
        text += "newmtl " + material.name + "\nKd";
        append_words(text, std::array{material.colour.r, material.colour.g, material.colour.b});
    }
    return text;
}

/// The path of the materials beside `path`, which the file names as one word: "a b/my tile.obj" has
/// "a b/my_tile.mtl".
std::string path_of_materials(const std::string& path) {
    const std::filesystem::path beside = std::filesystem::path(path).replace_extension(".mtl");
    std::string name = beside.filename().string();
    std::replace(name.begin(), name.end(), ' ', '_');
    return std::filesystem::path(beside).replace_filename(name).string();
}

}  // namespace

std::vector<std::string> obj_mesh_paths(const std::string& path) {
    return {path, path_of_materials(path)};
}

std::vector<EncodedFile> encode_obj_mesh(const SurfaceMesh& mesh, const std::string& path) {
    const std::vector<std::string> paths = obj_mesh_paths(path);
    const std::string material_file = std::filesystem::path(paths[1]).filename().string();
    std::vector<EncodedFile> files = only_file(paths[0], obj_text(mesh, material_file));
    files.push_back({paths[1], mtl_text(mesh)});
    return files;
}

std::vector<std::string> obj_paths(const std::string& path) {
    std::vector<std::string> paths = obj_mesh_paths(path);
    paths.push_back(std::filesystem::path(path).replace_extension(".seam.json").string());
    return paths;
}

std::vector<EncodedFile> encode_obj(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path) {
    require_finite(tile);
    TileColours colours = material_colours(tile, options);
    std::vector<int>& material = colours.class_of;
    std::vector<int> order(material.size());
    std::iota(order.begin(), order.end(), 0);
    cancellable_stable_sort(order.begin(), order.end(),
                            [&](int f, int g) { return material[f] < material[g]; });
    const plane::Tile sorted = with_faces_in_order(tile, order);
    std::sort(material.begin(), material.end());
    SurfaceMesh mesh = surface_mesh(sorted, SeamForm::kLines, options.site_orbits);
    mesh.texture = texture_coordinates(sorted);
    mesh.classes = std::move(colours.classes);
    mesh.face_class = std::move(material);
    std::vector<EncodedFile> files = encode_obj_mesh(mesh, path);
    files.push_back({obj_paths(path).back(), encode_seam(sorted)});
    return files;
}

}  // namespace pcvt
