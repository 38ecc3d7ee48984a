#include "io/graphics/obj_appearance.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/text.hpp"
#include "mesher/plane/tile/tile_valence.hpp"

namespace pcvt {
namespace {

constexpr const char* kRemedy = "; write the file again with pcvt";
/// Texture coordinates are compared within this many ulps of the largest.
constexpr float kUlps = 4;

void require_coordinates(const plane::Tile& tile, const ObjAppearance& appearance,
                         const std::string& path) {
    if (appearance.coordinates.empty() && !appearance.has_corners) return;
    if (appearance.other_index_line > 0) {
        throw BadFile(path + ":" + std::to_string(appearance.other_index_line) +
                      ": a corner has the texture coordinate of another vertex" + kRemedy);
    }
    if (!appearance.has_corners || appearance.coordinates.size() != tile.points.size()) {
        throw BadFile(path + ": there is not one texture coordinate for each vertex" + kRemedy);
    }
    const std::vector<plane::TextureCoordinate> wanted = texture_coordinates(tile);
    float largest = 1;
    for (const auto& [u, v] : wanted) largest = std::max({largest, std::abs(u), std::abs(v)});
    const float allowed = kUlps * std::numeric_limits<float>::epsilon() * largest;
    for (std::size_t v = 0; v < wanted.size(); ++v) {
        for (std::size_t k = 0; k < wanted[v].size(); ++k) {
            if (std::abs(appearance.coordinates[v][k] - wanted[v][k]) <= allowed) continue;
            throw BadFile(path + ": texture coordinate " + std::to_string(v + 1) +
                          " is not the lattice coordinate of its vertex" + kRemedy);
        }
    }
}

/// Reads the names that a material file defines, each with one colour.
class MaterialFile {
   public:
    explicit MaterialFile(const EncodedFile& file) : scanner_(file.path, file.bytes) {
        while (scanner_.next()) read_line();
        if (!last_.empty()) require_colour();
    }

    bool defines(std::string_view name) const { return n_colours_.count(name) > 0; }
    std::size_t size() const { return n_colours_.size(); }

   private:
    void read_line() {
        const std::vector<std::string_view>& words = scanner_.words();
        if (words.empty()) return;
        if (words[0] == "newmtl") {
            if (!last_.empty()) require_colour();
            if (words.size() != 2 || !n_colours_.emplace(words[1], 0).second) {
                scanner_.throw_bad_file(std::string("a material needs a name of its own") +
                                        kRemedy);
            }
            last_ = words[1];
        } else if (words[0] == "Kd") {
            read_colour();
        }
    }

    void read_colour() {
        const std::vector<std::string_view>& words = scanner_.words();
        bool in_range = words.size() == 4 && !last_.empty() && ++n_colours_[last_] == 1;
        for (std::size_t k = 1; k < words.size(); ++k) {
            const double part = scanner_.number(words[k]);
            in_range = in_range && part >= 0 && part <= 1;
        }
        if (in_range) return;
        scanner_.throw_bad_file(std::string("a material has one colour, 3 numbers from 0 to 1") +
                                kRemedy);
    }

    void require_colour() const {
        if (n_colours_.at(last_) == 1) return;
        scanner_.throw_bad_file("the material " + in_quotes(last_) + " has no colour" + kRemedy);
    }

    LineScanner scanner_;
    std::string_view last_;
    std::map<std::string_view, int> n_colours_;
};

/// Returns the number in a name `sides_N`; -1 of another name.
int named_sides(std::string_view name) {
    constexpr std::string_view kPrefix = "sides_";
    if (!name.starts_with(kPrefix)) return -1;
    try {
        return parse_integer(name.substr(kPrefix.size()));
    } catch (const InvalidInput&) {
        return -1;
    }
}

/// Whether the site of a face lies on a wall, which cuts its cell.
bool is_on_wall(const plane::Tile& tile, SiteId site) {
    if (site < 0 || static_cast<std::size_t>(site) >= tile.site_positions.size()) return false;
    return std::any_of(kWallSides.begin(), kWallSides.end(), [&](const WallSideRow& row) {
        return has_walls_across(tile.walls, row.axis) &&
               tile.site_positions[site][row.axis] == wall_line(row, tile.lattice);
    });
}

/// Returns the number of the material of each face.
std::vector<int> materials_of_faces(const plane::Tile& tile, const ObjAppearance& appearance,
                                    const std::string& path) {
    std::map<std::string_view, int> number;
    std::vector<int> of_face(static_cast<std::size_t>(tile.n_faces()), -1);
    for (std::size_t m = 0; m < appearance.materials.size(); ++m) {
        const auto& [name, first] = appearance.materials[m];
        const int last = m + 1 < appearance.materials.size()
                             ? appearance.materials[m + 1].first_face
                             : tile.n_faces();
        if (!number.emplace(name, static_cast<int>(m)).second || name.empty() || first == last) {
            throw BadFile(path + ": the faces of the material " + in_quotes(name) +
                          " are not in one row" + kRemedy);
        }
        std::fill(of_face.begin() + first, of_face.begin() + last, static_cast<int>(m));
    }
    if (of_face.front() < 0) throw BadFile(path + ": a face has no material" + kRemedy);
    return of_face;
}

void require_materials(const plane::Tile& tile, const ObjAppearance& appearance,
                       const std::string& path) {
    const std::vector<int> of_face = materials_of_faces(tile, appearance, path);
    const auto throw_other = [&](int f) {
        throw BadFile(path + ": face " + std::to_string(f + 1) +
                      " has the material of another face" + kRemedy);
    };
    if (tile.face_site.empty()) {
        if (appearance.materials.size() > 1) throw_other(appearance.materials[1].first_face);
        return;
    }
    // Where short edges were removed, the copies of a cell may have different numbers of sides.
    const bool is_moved = tile.kind == plane::MeshKind::kGrains || tile.short_edges > 0;
    if (is_moved && tile.columns * tile.rows != 1) return;
    std::vector<int> of_site(of_face.size(), -1);
    for (int f = 0; f < tile.n_faces(); ++f) {
        const SiteId site = tile.face_site[f];
        // The proof of the sites refuses such an id.
        if (site < 0 || site >= tile.n_faces()) continue;
        if (of_site[site] < 0) of_site[site] = of_face[f];
        if (of_site[site] != of_face[f]) throw_other(f);
    }
    // Pieces and grains have the number of sides of the whole cell.
    const bool are_whole =
        tile.kind == plane::MeshKind::kVoronoi && tile.columns > 0 &&
        tile.face_site.size() == tile.site_positions.size() * tile.columns * tile.rows;
    if (!are_whole) return;
    const std::vector<int> sides = cell_sides(tile);
    for (int f = 0; f < tile.n_faces(); ++f) {
        const int named = named_sides(appearance.materials[of_face[f]].name);
        if (named < 0 || named == sides[f] || is_on_wall(tile, tile.face_site[f])) continue;
        throw_other(f);
    }
}

void require_material_file(const ObjAppearance& appearance, const std::string& path,
                           const EncodedFile& file) {
    const std::string name = std::filesystem::path(file.path).filename().string();
    if (appearance.libraries.size() != 1 || appearance.libraries.front() != name) {
        throw BadFile(path + ": does not name the material file " + name + " beside it once" +
                      kRemedy);
    }
    const MaterialFile materials(file);
    if (materials.size() != appearance.materials.size()) {
        throw BadFile(file.path + ": defines other materials than the faces have" + kRemedy);
    }
    for (const auto& [material, first] : appearance.materials) {
        if (materials.defines(material)) continue;
        throw BadFile(file.path + ": does not define the material " + in_quotes(material) +
                      kRemedy);
    }
}

}  // namespace

std::vector<MaterialRun> material_runs(const ObjAppearance& appearance) {
    std::vector<MaterialRun> runs;
    for (const auto& [name, first] : appearance.materials)
        runs.push_back({std::string(name), first});
    return runs;
}

void require_own_appearance(const plane::Tile& tile, const ObjAppearance& appearance,
                            const std::string& path, const EncodedFile* materials) {
    require_coordinates(tile, appearance, path);
    if (appearance.materials.empty() && appearance.libraries.empty()) return;
    require_materials(tile, appearance, path);
    if (materials != nullptr) require_material_file(appearance, path, *materials);
}

}  // namespace pcvt
