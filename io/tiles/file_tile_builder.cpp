#include "io/tiles/file_tile_builder.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <utility>

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

void check_pair(const FileTileBuilder& file, std::initializer_list<int> vertices, Offset offset) {
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

MeshKind guess_kind(const FileTileBuilder& file) {
    for (int f = 0; f < file.faces.n_faces(); ++f) {
        checkpoint_each(f);
        if (file.faces.size(f) != 3) return MeshKind::kVoronoi;
    }
    return MeshKind::kDelaunay;
}

void check_sites(const FileTileBuilder& file, MeshKind kind) {
    const bool of_faces = faces_have_sites(kind);
    if (!file.kind && !file.site_positions.empty()) {
        throw_bad_file(file, "there are positions of sites, but no kind; write the file again");
    }
    if (file.sites.empty() && !file.site_positions.empty()) {
        throw_bad_file(file, "there are positions of sites, but no sites; give both or none");
    }
    const std::size_t owners = of_faces ? file.face_lines.size() : file.points.size();
    if (file.sites.empty() || file.sites.size() == owners) return;
    throw_bad_file(file, "there are " + std::to_string(file.sites.size()) + " sites for " +
                             std::to_string(owners) + (of_faces ? " faces" : " vertices") +
                             "; give one each or none");
}

}  // namespace

void FileTileBuilder::add_face(const std::vector<int>& vertices, int line) {
    faces.add(vertices);
    face_lines.push_back(line);
}

void FileTileBuilder::take_kind(const LineScanner& scanner,
                                std::span<const std::string_view> words) {
    const auto found = words.size() == 1 ? mesh_kind_of_file_word(words[0]) : std::nullopt;
    if (!found || kind)
        scanner.throw_bad_file("the kind is unclear; name it once: cells, triangles or grains");
    kind = found;
}

void FileTileBuilder::take_lattice(const LineScanner& scanner,
                                   std::span<const std::string_view> words) {
    if (words.size() != 4 || lattice) {
        scanner.throw_bad_file("the lattice is unclear; name it once, with 4 numbers: ax ay bx by");
    }
    std::array<double, 4> n{};
    for (std::size_t k = 0; k < n.size(); ++k) n[k] = scanner.number(words[k]);
    try {
        lattice.emplace(Vec2(n[0], n[1]), Vec2(n[2], n[3]));
    } catch (const InvalidInput& fault) {
        scanner.throw_bad_file(fault.what());
    }
}

void FileTileBuilder::take_periods(const LineScanner& scanner,
                                   std::span<const std::string_view> words) {
    if (words.size() != 2 || columns > 0) {
        scanner.throw_bad_file(
            "the periods are unclear; name their numbers of columns and rows once");
    }
    columns = scanner.integer(words[0]);
    rows = scanner.integer(words[1]);
    if (columns < 1 || rows < 1 || columns > kMostPeriods || rows > kMostPeriods) {
        scanner.throw_bad_file("the number of periods is not from 1 to " +
                               std::to_string(kMostPeriods));
    }
}

void FileTileBuilder::take_site(const LineScanner& scanner,
                                std::span<const std::string_view> words) {
    if (words.size() != 2) scanner.throw_bad_file("a site has 2 numbers; write x and y");
    site_positions.emplace_back(scanner.number(words[0]), scanner.number(words[1]));
}

void FileTileBuilder::take_short_edges(const LineScanner& scanner,
                                       std::span<const std::string_view> words) {
    if (words.size() != 1 || short_edges > 0) {
        scanner.throw_bad_file("the length of short edges is unclear; name it once");
    }
    short_edges = scanner.number(words[0]);
    if (!(short_edges > 0 && short_edges <= kLongestRemovedEdge)) {
        scanner.throw_bad_file("the length of short edges is not from 0 to 1");
    }
}

TileFile finish(FileTileBuilder file, const std::optional<Lattice>& lattice, Precision precision) {
    const bool states_lattice = file.lattice.has_value();
    resolve_numbers(file, lattice);
    if (file.points.empty()) throw_bad_file(file, "there is no vertex; give the file of a tile");
    if (file.face_lines.empty()) throw_bad_file(file, "there is no face; give the file of a tile");
    const MeshKind kind = file.kind.value_or(guess_kind(file));
    std::vector<int> scratch;
    for (int f = 0; f < file.faces.n_faces(); ++f)
        check_face(file, f, kind != MeshKind::kVoronoi, scratch);
    for (const VertexPair& p : file.vertex_pairs) check_pair(file, {p.v, p.w}, p.offset);
    for (const EdgePair& p : file.edge_pairs) check_pair(file, {p.v0, p.v1, p.w0, p.w1}, p.offset);
    check_sites(file, kind);
    if (!file.lattice) file.lattice = lattice;
    if (!file.lattice)
        throw_bad_file(file, "the file names no lattice; pass --lattice AX,AY,BX,BY");
    if (!file.site_positions.empty() && file.columns == 0) file.columns = file.rows = 1;
    const bool has_vertex_pairs = !file.vertex_pairs.empty();
    const bool has_edge_pairs = !file.edge_pairs.empty();
    Tile tile{.lattice = *file.lattice,
              .kind = kind,
              .points = std::move(file.points),
              .faces = std::move(file.faces),
              .vertex_pairs = std::move(file.vertex_pairs),
              .edge_pairs = std::move(file.edge_pairs),
              .columns = file.columns,
              .rows = file.rows,
              .short_edges = file.short_edges,
              .site_positions = std::move(file.site_positions),
              .order = file.order};
    (faces_have_sites(kind) ? tile.face_site : tile.vertex_site) = std::move(file.sites);
    return {std::move(tile), precision, has_vertex_pairs, has_edge_pairs, states_lattice};
}

}  // namespace pcvt
