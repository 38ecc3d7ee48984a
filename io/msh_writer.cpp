#include "io/msh_writer.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>

#include "io/boundary_runs.hpp"
#include "io/finite.hpp"
#include "io/raw_tile.hpp"
#include "io/text.hpp"
#include "io/triangle_elements.hpp"

namespace pcvt {
namespace {

constexpr int kLine = 1;
constexpr int kTriangle = 2;
constexpr int kPoints = 0;
constexpr int kCurves = 1;
constexpr int kSurfaces = 2;
constexpr int kSurface = 1;

template <class Number>
void append_words(std::string& text, std::initializer_list<Number> numbers) {
    for (const Number number : numbers) {
        append_number(text, number);
        text += ' ';
    }
}

template <class Number>
void append_line(std::string& text, std::initializer_list<Number> numbers) {
    append_words(text, numbers);
    text.back() = '\n';
}

/// The boundary as Gmsh sees it. Point k + 1 is where run k begins, curve k + 1 is run k.
struct Seam {
    std::vector<BoundaryRun> runs;
    /// Physical group of the curves with one offset, from 1.
    std::map<Offset, int> groups;

    int n_runs() const { return static_cast<int>(runs.size()); }
    int begin(int run) const { return runs[run].vertices.front(); }
    int surface_group() const { return static_cast<int>(groups.size()) + 1; }
};

Seam make_seam(const FlatTile& tile) {
    Seam seam{boundary_runs(tile), {}};
    for (const BoundaryRun& run : seam.runs) seam.groups[run.offset] = 0;
    int n = 0;
    for (auto& [offset, group] : seam.groups) group = ++n;
    return seam;
}

void append_head(std::string& text, const FlatTile& tile, const Seam& seam) {
    const Vec2& a = tile.lattice.a();
    const Vec2& b = tile.lattice.b();
    text += "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nA periodic tile, written by pcvt\n";
    text += "pcvt kind " + kind_word(tile.kind) + "\npcvt lattice ";
    append_line(text, {a.x(), a.y(), b.x(), b.y()});
    text += "$EndComments\n$PhysicalNames\n" + std::to_string(seam.surface_group()) + "\n";
    for (const auto& [offset, group] : seam.groups) {
        text += "1 " + std::to_string(group) + " \"" + seam_name(offset) + "\"\n";
    }
    text += "2 " + std::to_string(seam.surface_group()) + " \"tile\"\n$EndPhysicalNames\n";
}

/// `min_x min_y 0 max_x max_y 0 `.
template <class Vertices>
void append_bounds(std::string& text, const FlatTile& tile, const Vertices& vertices) {
    Vec2 low = tile.points[vertices.front()];
    Vec2 high = low;
    for (const int v : vertices) {
        low = low.cwiseMin(tile.points[v]);
        high = high.cwiseMax(tile.points[v]);
    }
    append_words(text, {low.x(), low.y(), 0.0, high.x(), high.y(), 0.0});
}

void append_entities(std::string& text, const FlatTile& tile, const Seam& seam) {
    const int n = seam.n_runs();
    text += "$Entities\n";
    append_line(text, {n, n, 1, 0});
    for (int k = 0; k < n; ++k) {
        const Vec2& p = tile.points[seam.begin(k)];
        append_words(text, {k + 1});
        append_words(text, {p.x(), p.y(), 0.0});
        append_line(text, {0});
    }
    for (int k = 0; k < n; ++k) {
        const BoundaryRun& run = seam.runs[k];
        append_words(text, {k + 1});
        append_bounds(text, tile, run.vertices);
        append_line(text, {1, seam.groups.at(run.offset), 2, k + 1, -((k + 1) % n + 1)});
    }
    text += "1 ";
    append_bounds(text, tile, tile.corners);
    append_words(text, {1, seam.surface_group(), n});
    for (int k = 0; k < n; ++k) append_words(text, {k + 1});
    text.back() = '\n';
    text += "$EndEntities\n";
}

/// One block of nodes; nothing for an entity without any of its own.
void append_block(std::string& text, const FlatTile& tile, int dimension, int entity,
                  const std::vector<int>& vertices) {
    if (vertices.empty()) return;
    append_line(text, {dimension, entity, 0, static_cast<int>(vertices.size())});
    for (const int v : vertices) append_line(text, {v + 1});
    for (const int v : vertices) {
        append_line(text, {tile.points[v].x(), tile.points[v].y(), 0.0});
    }
}

void append_nodes(std::string& text, const FlatTile& tile, const Seam& seam) {
    std::vector<bool> inside(tile.points.size(), true);
    int n_blocks = seam.n_runs();
    for (const BoundaryRun& run : seam.runs) {
        if (run.vertices.size() > 2) ++n_blocks;
        for (const int v : run.vertices) inside[v] = false;
    }
    std::vector<int> inner;
    for (int v = 0; v < tile.n_vertices(); ++v) {
        if (inside[v]) inner.push_back(v);
    }
    if (!inner.empty()) ++n_blocks;
    text += "$Nodes\n";
    append_line(text, {n_blocks, tile.n_vertices(), 1, tile.n_vertices()});
    for (int k = 0; k < seam.n_runs(); ++k) {
        append_block(text, tile, kPoints, k + 1, {seam.begin(k)});
    }
    for (int k = 0; k < seam.n_runs(); ++k) {
        const std::vector<int>& run = seam.runs[k].vertices;
        append_block(text, tile, kCurves, k + 1, {run.begin() + 1, run.end() - 1});
    }
    append_block(text, tile, kSurfaces, kSurface, inner);
    text += "$EndNodes\n";
}

int n_lines(const Seam& seam) {
    int n = 0;
    for (const BoundaryRun& run : seam.runs) n += static_cast<int>(run.vertices.size()) - 1;
    return n;
}

void append_elements(std::string& text, const FlatTile& tile, const Seam& seam) {
    const int n_elements = tile.n_faces() + n_lines(seam);
    text += "$Elements\n";
    append_line(text, {seam.n_runs() + 1, n_elements, 1, n_elements});
    int element = tile.n_faces();
    for (int k = 0; k < seam.n_runs(); ++k) {
        const std::vector<int>& run = seam.runs[k].vertices;
        append_line(text, {kCurves, k + 1, kLine, static_cast<int>(run.size()) - 1});
        for (std::size_t e = 0; e + 1 < run.size(); ++e) {
            append_line(text, {++element, run[e] + 1, run[e + 1] + 1});
        }
    }
    append_line(text, {kSurfaces, kSurface, kTriangle, tile.n_faces()});
    for (int f = 0; f < tile.n_faces(); ++f) {
        const int* corners = &tile.corners[tile.face_begin[f]];
        append_line(text, {f + 1, corners[0] + 1, corners[1] + 1, corners[2] + 1});
    }
    text += "$EndElements\n";
}

/// The head of one link: slave = master + translation(offset) as a 4 x 4 matrix, row by row.
void append_link(std::string& text, const FlatTile& tile, int dimension, int slave, int master,
                 Offset offset, std::size_t n_nodes) {
    const Vec2 t = tile.lattice.translation(offset);
    append_line(text, {dimension, slave, master});
    text += "16 ";
    append_words(text, {1.0, 0.0, 0.0, t.x()});
    append_words(text, {0.0, 1.0, 0.0, t.y()});
    append_line(text, {0, 0, 1, 0, 0, 0, 0, 1});
    append_line(text, {static_cast<int>(n_nodes)});
}

void append_curve_link(std::string& text, const FlatTile& tile, const Seam& seam, int k) {
    const BoundaryRun& slave = seam.runs[k];
    const BoundaryRun& master = seam.runs[slave.partner];
    const std::size_t n = slave.vertices.size();
    append_link(text, tile, kCurves, k + 1, slave.partner + 1, master.offset, n);
    for (std::size_t v = 0; v < n; ++v) {
        append_line(text, {slave.vertices[v] + 1, master.vertices[n - 1 - v] + 1});
    }
}

void append_periodic(std::string& text, const FlatTile& tile, const Seam& seam) {
    std::map<int, int> point_of;
    std::map<int, VertexPair> slaves;
    for (int k = 0; k < seam.n_runs(); ++k) point_of[seam.begin(k)] = k + 1;
    for (const VertexPair& pair : tile.vertex_pairs) {
        if (point_of.count(pair.w) > 0) slaves.emplace(point_of[pair.w], pair);
    }
    text += "$Periodic\n";
    append_line(text, {static_cast<int>(slaves.size()) + seam.n_runs() / 2});
    for (const auto& [point, pair] : slaves) {
        append_link(text, tile, kPoints, point, point_of.at(pair.v), pair.offset, 1);
        append_line(text, {pair.w + 1, pair.v + 1});
    }
    for (int k = 0; k < seam.n_runs(); ++k) {
        if (seam.runs[k].offset < Offset{}) append_curve_link(text, tile, seam, k);
    }
    text += "$EndPeriodic\n";
}

/// One integer for each of the first items of a list, `kRest` for those that follow.
void append_data(std::string& text, const char* section, const std::vector<int>& values,
                 int n_rest) {
    constexpr int kRest = -1;
    const int n = static_cast<int>(values.size());
    text += std::string("$") + section + "\n1\n\"cell_id\"\n1\n0\n3\n0\n1\n";
    append_line(text, {n + n_rest});
    for (int k = 0; k < n; ++k) append_line(text, {k + 1, values[k]});
    for (int k = n; k < n + n_rest; ++k) append_line(text, {k + 1, kRest});
    text += std::string("$End") + section + "\n";
}

}  // namespace

std::vector<EncodedFile> encode_msh(const FlatTile& tile, const std::string& path) {
    require_triangles(tile.kind, path);
    require_finite(tile);
    const Seam seam = make_seam(tile);
    std::string text;
    append_head(text, tile, seam);
    append_entities(text, tile, seam);
    append_nodes(text, tile, seam);
    append_elements(text, tile, seam);
    append_periodic(text, tile, seam);
    append_data(text, "ElementData", element_cells(tile), n_lines(seam));
    if (!tile.vertex_site.empty()) append_data(text, "NodeData", tile.vertex_site, 0);
    return {{path, text}};
}

std::vector<EncodedFile> encode_msh(const AnyTile& tile, const std::string& path) {
    return encode_msh(flatten(tile), path);
}

}  // namespace pcvt
