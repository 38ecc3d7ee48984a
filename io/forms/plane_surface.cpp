#include "io/forms/plane_surface.hpp"

#include <utility>

#include "io/forms/site_notes.hpp"
#include "io/forms/site_orbits.hpp"

namespace pcvt {
namespace {

constexpr const char* kLinesExplanation =
    "A periodic tile, written by pcvt. Comments that begin with \"# pcvt\" hold its seam:\n"
    "  kind cells|triangles|grains\n"
    "  lattice ax ay bx by        the period vectors a and b\n"
    "  vertex_pair v w i j        vertex w lies at vertex v + i a + j b\n"
    "  edge_pair v0 v1 w0 w1 i j  boundary edge v0 v1 + i a + j b is boundary edge w0 w1\n"
    "  sites s ...                the site of each face (or vertex of triangles), in order\n";
constexpr const char* kOrbitExplanation =
    "  site_orbits k ...          the orbit of site 0, 1, ... under the symmetry\n";
constexpr const char* kColumnsExplanation =
    "A periodic tile, written by pcvt\n"
    "position = position(orbit) + offset_i a + offset_j b, lattice ax ay bx by\n";

std::string explanation(SeamForm seam, bool has_orbits) {
    if (seam == SeamForm::kColumns) return kColumnsExplanation;
    std::string text = kLinesExplanation;
    append_note_meanings(text, "  ");
    if (has_orbits) text += kOrbitExplanation;
    return text + "Vertices count from 1, sites from 0.\n";
}

void add_pairs(const plane::Tile& tile, std::vector<NoteTable>& notes) {
    std::vector<int> vertices;
    for (const plane::VertexPair& p : tile.vertex_pairs) {
        vertices.insert(vertices.end(), {p.v, p.w, p.offset.i, p.offset.j});
    }
    notes.push_back(
        {.word = "vertex_pair", .width = 4, .n_indices = 2, .numbers = std::move(vertices)});
    std::vector<int> edges;
    for (const plane::EdgePair& p : tile.edge_pairs) {
        edges.insert(edges.end(), {p.v0, p.v1, p.w0, p.w1, p.offset.i, p.offset.j});
    }
    notes.push_back({.word = "edge_pair", .width = 6, .n_indices = 4, .numbers = std::move(edges)});
}

NoteTable vertex_orbits(const plane::Tile& tile) {
    // A vertex without a pair is its own representative.
    constexpr std::size_t kWidth = 3;
    std::vector<int> rows(kWidth * tile.points.size());
    for (int v = 0; v < tile.n_vertices(); ++v) rows[kWidth * static_cast<std::size_t>(v)] = v;
    for (const plane::VertexPair& pair : tile.vertex_pairs) {
        int* const row = rows.data() + kWidth * static_cast<std::size_t>(pair.w);
        row[0] = pair.v;
        row[1] = pair.offset.i;
        row[2] = pair.offset.j;
    }
    return {.columns = "orbit offset_i offset_j",
            .of = NoteOf::kVertices,
            .width = kWidth,
            .numbers = std::move(rows)};
}

}  // namespace

SurfaceMesh surface_mesh(const plane::Tile& tile, SeamForm seam, std::span<const int> site_orbits) {
    SurfaceMesh mesh{.explanation = explanation(seam, !site_orbits.empty()),
                     .kind = file_word(tile.kind)};
    mesh.points.reserve(tile.points.size());
    for (const plane::Vec2& p : tile.points) mesh.points.emplace_back(p.x(), p.y(), 0);
    mesh.faces = tile.faces;
    const plane::Vec2& a = tile.lattice.a();
    const plane::Vec2& b = tile.lattice.b();
    mesh.notes.push_back({.word = "lattice",
                          .width = 4,
                          .numbers = std::vector<double>{a.x(), a.y(), b.x(), b.y()}});
    if (seam == SeamForm::kLines) {
        add_pairs(tile, mesh.notes);
    } else {
        mesh.notes.push_back(vertex_orbits(tile));
    }
    const bool of_faces = faces_have_sites(tile.kind);
    mesh.notes.push_back({.word = "sites",
                          .columns = "site",
                          .of = of_faces ? NoteOf::kFaces : NoteOf::kVertices,
                          .numbers = tile.sites()});
    for (NoteTable& note : note_tables(tile)) mesh.notes.push_back(std::move(note));
    mesh.notes.push_back({.word = "site_orbits",
                          .numbers = std::vector<int>(site_orbits.begin(), site_orbits.end())});
    return mesh;
}

}  // namespace pcvt
