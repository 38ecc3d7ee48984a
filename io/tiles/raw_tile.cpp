#include "io/tiles/raw_tile.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace pcvt {
namespace {

[[noreturn]] void throw_bad_file(const RawTile& raw, const std::string& complaint) {
    throw BadFile(raw.name + ": " + complaint);
}

void check_face(const RawTile& raw, int f, bool must_be_triangle, std::vector<int>& face) {
    const auto throw_bad_face = [&](const std::string& complaint) {
        throw BadFile(raw.name + ":" + std::to_string(raw.face_lines[f]) + ": " + complaint);
    };
    face.assign(raw.corners.begin() + raw.face_begin[f],
                raw.corners.begin() + raw.face_begin[f + 1]);
    if (face.size() < 3) throw_bad_face("a face needs 3 corners; remove it");
    if (must_be_triangle && face.size() != 3) {
        throw_bad_face("a face of a triangle tile has 3 corners; correct the kind or the face");
    }
    std::sort(face.begin(), face.end());
    for (const int v : {face.front(), face.back()}) {
        if (v >= 0 && v < static_cast<int>(raw.points.size())) continue;
        throw_bad_face("vertex " + std::to_string(std::int64_t{v} + raw.index_base) +
                       " does not exist; correct the index");
    }
    const auto twice = std::adjacent_find(face.begin(), face.end());
    if (twice != face.end()) {
        throw_bad_face("vertex " + std::to_string(*twice + raw.index_base) +
                       " is a corner twice; name each corner once");
    }
}

void check_pair(const RawTile& raw, std::initializer_list<int> vertices, Offset offset) {
    const char* remedy = "; remove the pairs or write the file again with pcvt";
    for (const int v : vertices) {
        if (v >= 0 && v < static_cast<int>(raw.points.size())) continue;
        throw_bad_file(raw, "a pair names vertex " +
                                std::to_string(std::int64_t{v} + raw.index_base) +
                                ", which does not exist" + remedy);
    }
    for (const int k : {offset.i, offset.j}) {
        if (k < -kLargestOffset || k > kLargestOffset) {
            throw_bad_file(raw, "a pair has the offset " + std::to_string(k) + remedy);
        }
    }
}

MeshKind guess_kind(const RawTile& raw) {
    const std::size_t n_faces = raw.face_lines.size();
    for (std::size_t f = 0; f < n_faces; ++f) {
        if (raw.face_begin[f + 1] - raw.face_begin[f] != 3) return MeshKind::kVoronoi;
    }
    return MeshKind::kDelaunay;
}

void check_sites(const RawTile& raw, MeshKind kind) {
    const bool of_faces = faces_have_sites(kind);
    const std::size_t owners = of_faces ? raw.face_lines.size() : raw.points.size();
    if (raw.sites.empty() || raw.sites.size() == owners) return;
    throw_bad_file(raw, "there are " + std::to_string(raw.sites.size()) + " sites for " +
                            std::to_string(owners) + (of_faces ? " faces" : " vertices") +
                            "; give one each or none");
}

}  // namespace

void RawTile::add_face(const std::vector<int>& vertices, int line) {
    corners.insert(corners.end(), vertices.begin(), vertices.end());
    face_begin.push_back(static_cast<int>(corners.size()));
    face_lines.push_back(line);
}

void RawTile::take_kind(const LineScanner& scanner, std::span<const std::string_view> words) {
    const auto found = words.size() == 1 ? kind_of_word(words[0]) : std::nullopt;
    if (!found || kind)
        scanner.throw_bad_file("the kind is unclear; name it once: cells, triangles or grains");
    kind = found;
}

void RawTile::take_lattice(const LineScanner& scanner, std::span<const std::string_view> words) {
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

std::string kind_word(MeshKind kind) {
    switch (kind) {
        case MeshKind::kVoronoi:
            return "cells";
        case MeshKind::kDelaunay:
            return "triangles";
        case MeshKind::kGrains:
            return "grains";
    }
    return "";
}

std::optional<MeshKind> kind_of_word(std::string_view word) {
    for (const MeshKind kind : {MeshKind::kVoronoi, MeshKind::kDelaunay, MeshKind::kGrains}) {
        if (word == kind_word(kind)) return kind;
    }
    return std::nullopt;
}

TileFile finish(RawTile raw, const std::optional<Lattice>& lattice, Precision precision) {
    if (raw.points.empty()) throw_bad_file(raw, "there is no vertex; give the file of a tile");
    if (raw.face_lines.empty()) throw_bad_file(raw, "there is no face; give the file of a tile");
    const MeshKind kind = raw.kind.value_or(guess_kind(raw));
    const int n_faces = static_cast<int>(raw.face_lines.size());
    std::vector<int> scratch;
    for (int f = 0; f < n_faces; ++f) check_face(raw, f, kind != MeshKind::kVoronoi, scratch);
    for (const VertexPair& p : raw.vertex_pairs) check_pair(raw, {p.v, p.w}, p.offset);
    for (const EdgePair& p : raw.edge_pairs) check_pair(raw, {p.v0, p.v1, p.w0, p.w1}, p.offset);
    check_sites(raw, kind);
    if (!raw.lattice) raw.lattice = lattice;
    if (!raw.lattice) throw_bad_file(raw, "the file names no lattice; pass --lattice AX,AY,BX,BY");
    const bool has_vertex_pairs = !raw.vertex_pairs.empty();
    const bool has_edge_pairs = !raw.edge_pairs.empty();
    Tile tile{*raw.lattice,
              kind,
              std::move(raw.points),
              std::move(raw.face_begin),
              std::move(raw.corners),
              {},
              {},
              std::move(raw.vertex_pairs),
              std::move(raw.edge_pairs)};
    tile.order = raw.order;
    (faces_have_sites(kind) ? tile.face_site : tile.vertex_site) = std::move(raw.sites);
    return {std::move(tile), precision, has_vertex_pairs, has_edge_pairs};
}

}  // namespace pcvt
