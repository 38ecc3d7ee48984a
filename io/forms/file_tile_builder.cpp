#include "io/forms/file_tile_builder.hpp"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "io/forms/material_words.hpp"
#include "io/forms/site_orbits.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

[[noreturn]] void throw_bad_file(const FileTileBuilder& file, const std::string& complaint) {
    throw BadFile(file.name + ": " + complaint);
}

void check_face(const FileTileBuilder& file, int f, bool must_be_triangle, std::vector<int>& face) {
    const auto throw_bad_face = [&](const std::string& complaint) {
        throw BadFile(file.name + ":" + std::to_string(file.face_lines[f]) + ": " + complaint);
    };
    face.assign(file.faces[f].begin(), file.faces[f].end());
    if (face.size() < 3) throw_bad_face("a face needs 3 corners; remove it");
    if (must_be_triangle && face.size() != 3) {
        throw_bad_face("a face of a triangle tile has 3 corners; correct the kind or the face");
    }
    std::sort(face.begin(), face.end());
    for (const int v : {face.front(), face.back()}) {
        if (v >= 0 && v < static_cast<int>(file.points.size())) continue;
        throw_bad_face("vertex " + std::to_string(std::int64_t{v} + file.index_base) +
                       " does not exist; correct the index");
    }
    const auto twice = std::adjacent_find(face.begin(), face.end());
    if (twice != face.end()) {
        throw_bad_face("vertex " + std::to_string(*twice + file.index_base) +
                       " is a corner twice; name each corner once");
    }
}

void check_pair(const FileTileBuilder& file, std::initializer_list<int> vertices,
                plane::Offset offset) {
    const char* remedy = "; remove the pairs or write the file again with pcvt";
    for (const int v : vertices) {
        if (v >= 0 && v < static_cast<int>(file.points.size())) continue;
        throw_bad_file(file, "a pair names vertex " +
                                 std::to_string(std::int64_t{v} + file.index_base) +
                                 ", which does not exist" + remedy);
    }
    for (const int k : {offset.i, offset.j}) {
        if (k < -kLargestOffset || k > kLargestOffset) {
            throw_bad_file(file, "a pair has the offset " + std::to_string(k) + remedy);
        }
    }
}

plane::MeshKind guess_kind(const FileTileBuilder& file) {
    for (int f = 0; f < file.faces.n_faces(); ++f) {
        checkpoint_each(f);
        if (file.faces.size(f) != 3) return plane::MeshKind::kVoronoi;
    }
    return plane::MeshKind::kDelaunay;
}

/// @throws BadFile  a word is not a number.
std::vector<double> numbers_of(const LineScanner& scanner,
                               std::span<const std::string_view> words) {
    std::vector<double> numbers;
    for (const std::string_view word : words) numbers.push_back(scanner.number(word));
    return numbers;
}

plane::MeshKind read_kind(const LineScanner& scanner, std::span<const std::string_view> words) {
    const auto found = words.size() == 1 ? plane::mesh_kind_of_file_word(words[0]) : std::nullopt;
    if (!found)
        scanner.throw_bad_file("the kind is unclear; name it once: cells, triangles or grains");
    return *found;
}

plane::Lattice read_lattice(const LineScanner& scanner, std::span<const std::string_view> words) {
    if (words.size() != 4) {
        scanner.throw_bad_file("the lattice is unclear; name it once, with 4 numbers: ax ay bx by");
    }
    const std::vector<double> n = numbers_of(scanner, words);
    try {
        return {plane::Vec2(n[0], n[1]), plane::Vec2(n[2], n[3])};
    } catch (const InvalidInput& fault) {
        scanner.throw_bad_file(fault.what());
    }
}

/// @returns whether the key is that of a note.
bool take_note_comment(const LineScanner& scanner, std::string_view key,
                       std::span<const std::string_view> words, SiteNotes& notes) {
    const SiteNote* const note = find_site_note(key);
    if (note == nullptr && key != "site") return false;
    const std::vector<double> numbers = numbers_of(scanner, words);
    try {
        note == nullptr ? take_site_note(numbers, notes) : take_note(*note, numbers, notes);
    } catch (const InvalidInput& fault) {
        scanner.throw_bad_file(fault.what());
    }
    return true;
}

void take_hole_comment(const LineScanner& scanner, std::span<const std::string_view> words,
                       int index_base, SiteNotes& notes) {
    if (words.empty()) scanner.throw_bad_file("a hole lacks its name and its edges; give both");
    std::vector<double> vertices;
    for (const std::string_view word : words.subspan(1)) {
        vertices.push_back(double(scanner.integer(word)) - index_base);
    }
    try {
        take_hole_note(words.front(), vertices, notes);
    } catch (const InvalidInput& fault) {
        scanner.throw_bad_file(fault.what());
    }
}

}  // namespace

void FileTileBuilder::add_face(const std::vector<int>& vertices, int line) {
    faces.add(vertices);
    face_lines.push_back(line);
}

bool FileTileBuilder::take_comment(const LineScanner& scanner, std::string_view key,
                                   std::span<const std::string_view> words) {
    if (key == "sites") {
        for (const std::string_view word : words) sites.push_back(scanner.integer(word));
        return true;
    }
    if (key == "hole") {
        take_hole_comment(scanner, words, index_base, notes);
        return true;
    }
    if (key == "site_orbits") {
        for (const std::string_view word : words) site_orbits.push_back(scanner.integer(word));
        states_all_orbits = true;
        return true;
    }
    if (key != "site" && std::find(stated.begin(), stated.end(), key) != stated.end()) {
        scanner.throw_bad_file("a second line states the " + std::string(key) + "; keep one");
    }
    if (key == "kind") {
        kind = read_kind(scanner, words);
    } else if (key == "lattice") {
        lattice = read_lattice(scanner, words);
    } else if (!take_note_comment(scanner, key, words, notes)) {
        return false;
    }
    stated.push_back(key);
    return true;
}

void give_sites(FileTileBuilder file, plane::Tile& tile) {
    const bool of_faces = faces_have_sites(tile.kind);
    const SiteNotes& notes = file.notes;
    if (!file.kind && !notes.positions.empty()) {
        throw_bad_file(file, "there are positions of sites, but no kind; write the file again");
    }
    if (file.sites.empty() && !notes.positions.empty()) {
        throw_bad_file(file, "there are positions of sites, but no sites; give both or none");
    }
    if (!notes.weights.empty() && notes.weights.size() != notes.positions.size()) {
        throw_bad_file(file, "there are " + std::to_string(notes.weights.size()) + " weights for " +
                                 std::to_string(notes.positions.size()) +
                                 " sites; give one each or none");
    }
    const std::size_t owners = of_faces ? tile.faces.begin.size() - 1 : tile.points.size();
    if (!file.sites.empty() && file.sites.size() != owners) {
        throw_bad_file(file, "there are " + std::to_string(file.sites.size()) + " sites for " +
                                 std::to_string(owners) + (of_faces ? " faces" : " vertices") +
                                 "; give one each or none");
    }
    try {
        std::move(file.notes).give_to(tile);
    } catch (const InvalidInput& fault) {
        throw_bad_file(file, fault.what());
    }
    (of_faces ? tile.face_site : tile.vertex_site) = std::move(file.sites);
}

std::int64_t n_stated_sites(const plane::Tile& tile) {
    const std::vector<SiteId>& sites = tile.sites();
    return sites.empty() ? 0 : 1 + std::int64_t{*std::max_element(sites.begin(), sites.end())};
}

TileFile finish(FileTileBuilder file, const std::optional<plane::Lattice>& lattice,
                plane::Precision precision) {
    const bool states_lattice = file.lattice.has_value();
    resolve_numbers(file, lattice);
    if (file.points.empty()) throw_bad_file(file, "there is no vertex; give the file of a tile");
    if (file.face_lines.empty()) throw_bad_file(file, "there is no face; give the file of a tile");
    const plane::MeshKind kind = file.kind.value_or(guess_kind(file));
    std::vector<int> scratch;
    for (int f = 0; f < file.faces.n_faces(); ++f)
        check_face(file, f, kind != plane::MeshKind::kVoronoi, scratch);
    for (const plane::VertexPair& p : file.vertex_pairs) check_pair(file, {p.v, p.w}, p.offset);
    for (const plane::EdgePair& p : file.edge_pairs)
        check_pair(file, {p.v0, p.v1, p.w0, p.w1}, p.offset);
    if (!file.lattice) file.lattice = lattice;
    if (!file.lattice)
        throw UnusableFile(file.name + ": the file names no lattice; pass --lattice AX,AY,BX,BY");
    const bool has_vertex_pairs = !file.vertex_pairs.empty();
    const bool has_edge_pairs = !file.edge_pairs.empty();
    plane::Tile tile{.lattice = *file.lattice,
                     .kind = kind,
                     .points = std::move(file.points),
                     .faces = std::move(file.faces),
                     .vertex_pairs = std::move(file.vertex_pairs),
                     .edge_pairs = std::move(file.edge_pairs),
                     .order = file.order};
    CellMaterials materials = std::move(file.materials);
    std::vector<int> site_orbits = std::move(file.site_orbits);
    const bool states_all_orbits = file.states_all_orbits;
    const std::string name = file.name;
    give_sites(std::move(file), tile);
    const std::int64_t n_sites = n_stated_sites(tile);
    require_materials(name, materials, n_sites);
    require_site_orbits(name, site_orbits, n_sites, states_all_orbits);
    return {.tile = std::move(tile),
            .precision = precision,
            .has_vertex_pairs = has_vertex_pairs,
            .has_edge_pairs = has_edge_pairs,
            .states_lattice = states_lattice,
            .materials = std::move(materials),
            .site_orbits = std::move(site_orbits)};
}

}  // namespace pcvt
