#include "io/solvers/msh_writer.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>

#include "io/bytes/text.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/seam_segments.hpp"
#include "io/tiles/solver_nodes.hpp"
#include "io/tiles/triangle_elements.hpp"

namespace pcvt {
namespace {

/// Gmsh's element types by the order of the tile.
constexpr int kLine[] = {0, 1, 8};
constexpr int kTriangle[] = {0, 2, 9};
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

/// The boundary in Gmsh's entities: seam segment k is curve k + 1 and begins at point k + 1.
struct Seam {
    std::vector<SeamSegment> segments;
    /// The physical group of all curves with one offset, counted from 1.
    std::map<Offset, int> groups;

    int n_segments() const { return static_cast<int>(segments.size()); }
    int begin(int segment) const { return segments[segment].vertices.front(); }
    int surface_group() const { return static_cast<int>(groups.size()) + 1; }
};

Seam make_seam(const Tile& tile, const SolverNodes& nodes) {
    Seam seam{seam_segments(tile, nodes.middles), {}};
    for (const SeamSegment& segment : seam.segments) seam.groups[segment.offset] = 0;
    int n = 0;
    for (auto& [offset, group] : seam.groups) group = ++n;
    return seam;
}

void append_head(std::string& text, const Tile& tile, const Seam& seam) {
    const Vec2& a = tile.lattice.a();
    const Vec2& b = tile.lattice.b();
    text += "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nA periodic tile, written by pcvt\n";
    text += "pcvt kind " + file_word(tile.kind) + "\npcvt lattice ";
    append_line(text, {a.x(), a.y(), b.x(), b.y()});
    text += "$EndComments\n$PhysicalNames\n" + std::to_string(seam.surface_group()) + "\n";
    for (const auto& [offset, group] : seam.groups) {
        text += "1 " + std::to_string(group) + " \"" + seam_name(offset) + "\"\n";
    }
    text += "2 " + std::to_string(seam.surface_group()) + " \"tile\"\n$EndPhysicalNames\n";
}

/// Appends `min_x min_y 0 max_x max_y 0 `.
template <class Vertices>
void append_bounds(std::string& text, const Tile& tile, const Vertices& vertices) {
    Vec2 low = tile.points[vertices.front()];
    Vec2 high = low;
    for (const int v : vertices) {
        low = low.cwiseMin(tile.points[v]);
        high = high.cwiseMax(tile.points[v]);
    }
    append_words(text, {low.x(), low.y(), 0.0, high.x(), high.y(), 0.0});
}

void append_entities(std::string& text, const Tile& tile, const Seam& seam) {
    // Numbers of points, curves, surfaces and volumes.
    const int n = seam.n_segments();
    text += "$Entities\n";
    append_line(text, {n, n, 1, 0});
    // Points without a physical group.
    for (int k = 0; k < n; ++k) {
        const Vec2& p = tile.points[seam.begin(k)];
        append_words(text, {k + 1});
        append_words(text, {p.x(), p.y(), 0.0});
        append_line(text, {0});
    }
    // Curves with their physical group and their two ends.
    for (int k = 0; k < n; ++k) {
        const SeamSegment& segment = seam.segments[k];
        append_words(text, {k + 1});
        append_bounds(text, tile, segment.vertices);
        append_line(text, {1, seam.groups.at(segment.offset), 2, k + 1, -((k + 1) % n + 1)});
    }
    // The surface, with all curves as its boundary.
    text += "1 ";
    append_bounds(text, tile, tile.faces.corners);
    append_words(text, {1, seam.surface_group(), n});
    for (int k = 0; k < n; ++k) append_words(text, {k + 1});
    text.back() = '\n';
    text += "$EndEntities\n";
}

/// Appends one block of nodes; nothing for an entity without nodes of its own.
void append_block(std::string& text, const SolverNodes& nodes, int dimension, int entity,
                  const std::vector<int>& block) {
    if (block.empty()) return;
    append_line(text, {dimension, entity, 0, static_cast<int>(block.size())});
    for (const int v : block) append_line(text, {v + 1});
    for (const int v : block) {
        append_line(text, {nodes.points[v].x(), nodes.points[v].y(), 0.0});
    }
}

/// Returns the nodes of a curve without its ends.
std::vector<int> inner_nodes(const SeamSegment& segment) {
    std::vector<int> inner(segment.vertices.begin() + 1, segment.vertices.end() - 1);
    inner.insert(inner.end(), segment.middles.begin(), segment.middles.end());
    return inner;
}

/// Returns the nodes of the surface that lie on no curve.
std::vector<int> surface_nodes(const SolverNodes& nodes, const Seam& seam) {
    std::vector<bool> inside(nodes.points.size(), true);
    for (const SeamSegment& segment : seam.segments) {
        for (const int v : segment.vertices) inside[v] = false;
        for (const int v : segment.middles) inside[v] = false;
    }
    std::vector<int> inner;
    for (int v = 0; v < nodes.n_nodes(); ++v) {
        if (inside[v]) inner.push_back(v);
    }
    return inner;
}

void append_nodes(std::string& text, const SolverNodes& nodes, const Seam& seam) {
    const std::vector<int> surface = surface_nodes(nodes, seam);
    int n_blocks = seam.n_segments() + (surface.empty() ? 0 : 1);
    for (const SeamSegment& segment : seam.segments)
        n_blocks += inner_nodes(segment).empty() ? 0 : 1;
    text += "$Nodes\n";
    append_line(text, {n_blocks, nodes.n_nodes(), 1, nodes.n_nodes()});
    for (int k = 0; k < seam.n_segments(); ++k) {
        append_block(text, nodes, kPoints, k + 1, {seam.begin(k)});
    }
    for (int k = 0; k < seam.n_segments(); ++k) {
        append_block(text, nodes, kCurves, k + 1, inner_nodes(seam.segments[k]));
    }
    append_block(text, nodes, kSurfaces, kSurface, surface);
    text += "$EndNodes\n";
}

int n_lines(const Seam& seam) {
    int n = 0;
    for (const SeamSegment& segment : seam.segments)
        n += static_cast<int>(segment.vertices.size()) - 1;
    return n;
}

void append_elements(std::string& text, const Tile& tile, const SolverNodes& nodes,
                     const Seam& seam) {
    // Lines come first in the file; their numbers follow the numbers of the triangles.
    const int n_elements = tile.n_faces() + n_lines(seam);
    text += "$Elements\n";
    append_line(text, {seam.n_segments() + 1, n_elements, 1, n_elements});
    int element = tile.n_faces();
    for (int k = 0; k < seam.n_segments(); ++k) {
        const SeamSegment& segment = seam.segments[k];
        const std::size_t n = segment.vertices.size() - 1;
        append_line(text, {kCurves, k + 1, kLine[tile.order], static_cast<int>(n)});
        for (std::size_t e = 0; e < n; ++e) {
            append_words(text, {++element, segment.vertices[e] + 1, segment.vertices[e + 1] + 1});
            if (!segment.middles.empty()) append_words(text, {segment.middles[e] + 1});
            text.back() = '\n';
        }
    }
    // Triangles.
    append_line(text, {kSurfaces, kSurface, kTriangle[tile.order], tile.n_faces()});
    for (int f = 0; f < tile.n_faces(); ++f) {
        append_words(text, {f + 1});
        for (const int v : element_nodes(tile, nodes, f)) append_words(text, {v + 1});
        text.back() = '\n';
    }
    text += "$EndElements\n";
}

/// Appends the head of one link: slave = master + translation(offset) as a 4 x 4 matrix, row by
/// row.
void append_link(std::string& text, const Tile& tile, int dimension, int slave, int master,
                 Offset offset, std::size_t n_nodes) {
    const Vec2 t = tile.lattice.translation(offset);
    append_line(text, {dimension, slave, master});
    text += "16 ";
    append_words(text, {1.0, 0.0, 0.0, t.x()});
    append_words(text, {0.0, 1.0, 0.0, t.y()});
    append_line(text, {0, 0, 1, 0, 0, 0, 0, 1});
    append_line(text, {static_cast<int>(n_nodes)});
}

void append_curve_link(std::string& text, const Tile& tile, const Seam& seam, int k) {
    const SeamSegment& slave = seam.segments[k];
    const SeamSegment& master = seam.segments[slave.partner];
    const auto append_pairs = [&](const std::vector<int>& slaves, const std::vector<int>& masters) {
        for (std::size_t v = 0; v < slaves.size(); ++v) {
            append_line(text, {slaves[v] + 1, masters[slaves.size() - 1 - v] + 1});
        }
    };
    append_link(text, tile, kCurves, k + 1, slave.partner + 1, master.offset,
                slave.vertices.size() + slave.middles.size());
    append_pairs(slave.vertices, master.vertices);
    append_pairs(slave.middles, master.middles);
}

void append_periodic(std::string& text, const Tile& tile, const Seam& seam) {
    std::map<int, int> point_of;
    std::map<int, VertexPair> slaves;
    for (int k = 0; k < seam.n_segments(); ++k) point_of[seam.begin(k)] = k + 1;
    for (const VertexPair& pair : tile.vertex_pairs) {
        if (point_of.count(pair.w) > 0) slaves.emplace(point_of[pair.w], pair);
    }
    text += "$Periodic\n";
    append_line(text, {static_cast<int>(slaves.size()) + seam.n_segments() / 2});
    for (const auto& [point, pair] : slaves) {
        append_link(text, tile, kPoints, point, point_of.at(pair.v), pair.offset, 1);
        append_line(text, {pair.w + 1, pair.v + 1});
    }
    for (int k = 0; k < seam.n_segments(); ++k) {
        if (seam.segments[k].offset < Offset{}) append_curve_link(text, tile, seam, k);
    }
    text += "$EndPeriodic\n";
}

/// Appends a section with the values of the first elements or nodes, and kRest for `n_rest` more.
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

std::vector<EncodedFile> encode_msh(const Tile& tile, const std::string& path) {
    require_triangles(tile.kind, path);
    require_finite(tile);
    const SolverNodes nodes = solver_nodes(tile);
    const Seam seam = make_seam(tile, nodes);
    std::string text;
    append_head(text, tile, seam);
    append_entities(text, tile, seam);
    append_nodes(text, nodes, seam);
    append_elements(text, tile, nodes, seam);
    append_periodic(text, tile, seam);
    append_data(text, "ElementData", element_cells(tile), n_lines(seam));
    if (!tile.vertex_site.empty()) append_data(text, "NodeData", tile.vertex_site, 0);
    return only_file(path, std::move(text));
}

}  // namespace pcvt
