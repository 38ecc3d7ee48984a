#include "io/solvers/msh_writer.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "io/bytes/msh_text.hpp"
#include "io/forms/solver_nodes.hpp"
#include "io/forms/triangle_elements.hpp"
#include "io/solvers/msh_groups.hpp"
#include "io/solvers/msh_model.hpp"
#include "io/tiles/finite.hpp"
#include "io/tiles/material_words.hpp"
#include "io/tiles/site_notes.hpp"
#include "io/tiles/site_orbits.hpp"

namespace pcvt {
namespace {

/// Gmsh's element types by the order of the tile.
constexpr int kLineOfOrder[] = {0, 1, 8};
constexpr int kTriangleOfOrder[] = {0, 2, 9};
constexpr const char* kCellView = "cell_id";
constexpr const char* kOrbitView = "orbit";

void append_head(std::string& text, const plane::Tile& tile, const MshModel& model,
                 std::span<const int> site_orbits) {
    const plane::Vec2& a = tile.lattice.a();
    const plane::Vec2& b = tile.lattice.b();
    text += "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nA periodic tile, written by pcvt\n";
    text += "pcvt kind " + file_word(tile.kind) + "\npcvt lattice ";
    append_msh_line(text, {a.x(), a.y(), b.x(), b.y()});
    append_note_comments(text, "pcvt ", tile, 1);
    append_materials(text, "pcvt ", model.materials);
    append_site_orbits(text, "pcvt ", site_orbits);
    text += "$EndComments\n$PhysicalNames\n";
    const std::size_t n = model.seam_groups.size() + model.wall_groups.size() +
                          model.entities.surfaces.size() + model.phases.size();
    append_msh_line(text, {static_cast<int>(n) + (model.has_boundary ? 1 : 0)});
    for (const auto& [offset, group] : model.seam_groups) {
        append_msh_name(text, kMshCurves, group, seam_name(offset));
    }
    for (const auto& [wall, group] : model.wall_groups) {
        append_msh_name(text, kMshCurves, group, wall_name(tile, wall));
    }
    if (model.has_boundary)
        append_msh_name(text, kMshCurves, model.boundary_group, std::string(kGrainBoundarySet));
    for (const MshSurface& cell : model.entities.surfaces) {
        append_msh_name(text, kMshSurfaces, cell.site + 1,
                        std::string(kCellSet) + std::to_string(cell.site));
    }
    for (const int phase : model.phases) {
        append_msh_name(text, kMshSurfaces, model.phase_group + phase,
                        phase_group(model.materials.phase_names[phase]));
    }
    text += "$EndPhysicalNames\n";
}

/// The smallest box around some points.
struct Bounds {
    plane::Vec2 low;
    plane::Vec2 high;

    explicit Bounds(const plane::Vec2& p) : low(p), high(p) {}
    void add(const plane::Vec2& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
};

/// Appends `min_x min_y 0 max_x max_y 0 `.
void append_bounds(std::string& text, const Bounds& bounds) {
    append_msh_words(text, {bounds.low.x(), bounds.low.y(), 0.0});
    append_msh_words(text, {bounds.high.x(), bounds.high.y(), 0.0});
}

void append_points(std::string& text, const plane::Tile& tile, const MshModel& model) {
    // Points without a physical group.
    for (std::size_t k = 0; k < model.entities.points.size(); ++k) {
        const plane::Vec2& p = tile.points[model.entities.points[k]];
        append_msh_words(text, {static_cast<int>(k) + 1});
        append_msh_words(text, {p.x(), p.y(), 0.0});
        append_msh_line(text, {0});
    }
}

void append_curves(std::string& text, const plane::Tile& tile, const MshModel& model) {
    // Curves with their physical group and their two ends.
    for (int k = 0; k < model.n_curves(); ++k) {
        const MshCurve& curve = model.entities.curves[k];
        Bounds bounds(tile.points[curve.vertices.front()]);
        for (const int v : curve.vertices) bounds.add(tile.points[v]);
        append_msh_words(text, {k + 1});
        append_bounds(text, bounds);
        append_msh_line(text, {1, model.group(curve), 2, model.point_tag[curve.vertices.front()],
                               -model.point_tag[curve.vertices.back()]});
    }
}

void append_surfaces(std::string& text, const plane::Tile& tile, const MshModel& model) {
    // Surfaces with the curves that have them on their left, and on their right.
    for (const MshSurface& cell : model.entities.surfaces) {
        Bounds bounds(tile.points[tile.faces[cell.triangles.front()].front()]);
        for (const int f : cell.triangles) {
            for (const int v : tile.faces[f]) bounds.add(tile.points[v]);
        }
        append_msh_words(text, {cell.site + 1});
        append_bounds(text, bounds);
        const std::size_t n = cell.left_of.size() + cell.right_of.size();
        const std::vector<int> groups = model.groups(cell);
        append_msh_words(text, {static_cast<int>(groups.size())});
        for (const int group : groups) append_msh_words(text, {group});
        append_msh_words(text, {static_cast<int>(n)});
        for (const int k : cell.left_of) append_msh_words(text, {k + 1});
        for (const int k : cell.right_of) append_msh_words(text, {-(k + 1)});
        text.back() = '\n';
    }
}

void append_entities(std::string& text, const plane::Tile& tile, const MshModel& model) {
    // Numbers of points, curves, surfaces and volumes.
    text += "$Entities\n";
    append_msh_line(text, {static_cast<int>(model.entities.points.size()), model.n_curves(),
                           static_cast<int>(model.entities.surfaces.size()), 0});
    append_points(text, tile, model);
    append_curves(text, tile, model);
    append_surfaces(text, tile, model);
    text += "$EndEntities\n";
}

/// Appends one block of nodes; nothing for an entity without nodes of its own.
void append_block(std::string& text, const SolverNodes& nodes, int dimension, int entity,
                  const std::vector<int>& block) {
    if (block.empty()) return;
    append_msh_line(text, {dimension, entity, 0, static_cast<int>(block.size())});
    for (const int v : block) append_msh_line(text, {v + 1});
    for (const int v : block) {
        append_msh_line(text, {nodes.points[v].x(), nodes.points[v].y(), 0.0});
    }
}

/// Returns the nodes of a curve without its ends.
std::vector<int> inner_nodes(const MshCurve& curve) {
    std::vector<int> inner(curve.vertices.begin() + 1, curve.vertices.end() - 1);
    inner.insert(inner.end(), curve.middles.begin(), curve.middles.end());
    return inner;
}

void append_nodes(std::string& text, const SolverNodes& nodes, const MshModel& model) {
    const MshEntities& entities = model.entities;
    std::size_t n_blocks = entities.points.size();
    for (const MshCurve& curve : entities.curves) n_blocks += inner_nodes(curve).empty() ? 0 : 1;
    for (const MshSurface& cell : entities.surfaces) n_blocks += cell.nodes.empty() ? 0 : 1;
    text += "$Nodes\n";
    append_msh_line(text, {static_cast<int>(n_blocks), nodes.n_nodes(), 1, nodes.n_nodes()});
    for (std::size_t k = 0; k < entities.points.size(); ++k) {
        append_block(text, nodes, kMshPoints, static_cast<int>(k) + 1, {entities.points[k]});
    }
    for (int k = 0; k < model.n_curves(); ++k) {
        append_block(text, nodes, kMshCurves, k + 1, inner_nodes(entities.curves[k]));
    }
    for (const MshSurface& cell : entities.surfaces) {
        append_block(text, nodes, kMshSurfaces, cell.site + 1, cell.nodes);
    }
    text += "$EndNodes\n";
}

int n_lines(const MshModel& model) {
    int n = 0;
    for (const MshCurve& curve : model.entities.curves)
        n += static_cast<int>(curve.vertices.size()) - 1;
    return n;
}

void append_elements(std::string& text, const plane::Tile& tile, const SolverNodes& nodes,
                     const MshModel& model) {
    // Lines come first in the file; their numbers follow the numbers of the triangles.
    const int n_elements = tile.n_faces() + n_lines(model);
    const int n_blocks = model.n_curves() + static_cast<int>(model.entities.surfaces.size());
    text += "$Elements\n";
    append_msh_line(text, {n_blocks, n_elements, 1, n_elements});
    int element = tile.n_faces();
    for (int k = 0; k < model.n_curves(); ++k) {
        const MshCurve& curve = model.entities.curves[k];
        const std::size_t n = curve.vertices.size() - 1;
        append_msh_line(text, {kMshCurves, k + 1, kLineOfOrder[tile.order], static_cast<int>(n)});
        for (std::size_t e = 0; e < n; ++e) {
            append_msh_words(text, {++element, curve.vertices[e] + 1, curve.vertices[e + 1] + 1});
            if (!curve.middles.empty()) append_msh_words(text, {curve.middles[e] + 1});
            text.back() = '\n';
        }
    }
    for (const MshSurface& cell : model.entities.surfaces) {
        const int n = static_cast<int>(cell.triangles.size());
        append_msh_line(text, {kMshSurfaces, cell.site + 1, kTriangleOfOrder[tile.order], n});
        for (const int f : cell.triangles) {
            append_msh_words(text, {f + 1});
            for (const int v : element_nodes(tile, nodes, f)) append_msh_words(text, {v + 1});
            text.back() = '\n';
        }
    }
    text += "$EndElements\n";
}

std::array<double, 3> translation(const plane::Tile& tile, plane::Offset offset) {
    const plane::Vec2 t = tile.lattice.translation(offset);
    return {t.x(), t.y(), 0};
}

void append_curve_link(std::string& text, const plane::Tile& tile, const MshModel& model, int k) {
    const MshCurve& slave = model.entities.curves[k];
    const MshCurve& master = model.entities.curves[slave.partner];
    const auto append_pairs = [&](const std::vector<int>& slaves, const std::vector<int>& masters) {
        for (std::size_t v = 0; v < slaves.size(); ++v) {
            append_msh_line(text, {slaves[v] + 1, masters[slaves.size() - 1 - v] + 1});
        }
    };
    append_msh_link(text, kMshCurves, k + 1, slave.partner + 1, translation(tile, master.offset),
                    slave.vertices.size() + slave.middles.size());
    append_pairs(slave.vertices, master.vertices);
    append_pairs(slave.middles, master.middles);
}

/// The link of each point to the image of it with the smallest offset, by the tags of the slaves.
std::map<int, plane::VertexPair> point_links(const plane::Tile& tile, const MshModel& model) {
    // The image with the smallest offset, by the representative.
    std::map<int, plane::VertexPair> masters;
    for (const plane::VertexPair& pair : tile.vertex_pairs) {
        plane::VertexPair& master =
            masters.try_emplace(pair.v, plane::VertexPair{pair.v, pair.v, plane::Offset{}})
                .first->second;
        if (pair.offset < master.offset) master = pair;
    }
    std::map<int, plane::VertexPair> links;
    const auto link = [&](int v, int representative, plane::Offset offset) {
        const plane::VertexPair& master = masters.at(representative);
        if (model.point_tag[v] == 0 || v == master.w) return;
        links.emplace(model.point_tag[v], plane::VertexPair{master.w, v, offset - master.offset});
    };
    for (const auto& [representative, master] : masters) link(representative, representative, {});
    for (const plane::VertexPair& pair : tile.vertex_pairs) link(pair.w, pair.v, pair.offset);
    return links;
}

void append_periodic(std::string& text, const plane::Tile& tile, const MshModel& model) {
    const std::map<int, plane::VertexPair> links = point_links(tile, model);
    std::vector<int> slaves;
    for (int k = 0; k < model.n_curves(); ++k) {
        const MshCurve& curve = model.entities.curves[k];
        if (curve.is_seam() && curve.offset < plane::Offset{}) slaves.push_back(k);
    }
    // A box between four walls has no periodic entities.
    if (slaves.empty()) return;
    text += "$Periodic\n";
    append_msh_line(text, {static_cast<int>(links.size() + slaves.size())});
    for (const auto& [point, pair] : links) {
        append_msh_link(text, kMshPoints, point, model.point_tag[pair.v],
                        translation(tile, pair.offset), 1);
        append_msh_line(text, {pair.w + 1, pair.v + 1});
    }
    for (const int k : slaves) append_curve_link(text, tile, model, k);
    text += "$EndPeriodic\n";
}

/// The value of elements and nodes that belong to no cell: lines and midside nodes.
constexpr int kNoCell = -1;

/// The values of triangles, and kNoCell for lines, in the order of append_elements().
std::vector<MshValue> element_values(const plane::Tile& tile, const MshModel& model,
                                     const std::vector<int>& of_triangle) {
    std::vector<MshValue> values;
    for (int e = tile.n_faces(); e < tile.n_faces() + n_lines(model); ++e) {
        values.push_back({e + 1, kNoCell});
    }
    for (const MshSurface& cell : model.entities.surfaces) {
        for (const int f : cell.triangles) values.push_back({f + 1, of_triangle[f]});
    }
    return values;
}

/// The sites of vertices, and kNoCell for midside nodes, in the order of append_nodes().
std::vector<MshValue> node_values(const MshModel& model, const std::vector<SiteId>& of_vertex) {
    const int n_vertices = static_cast<int>(of_vertex.size());
    std::vector<MshValue> values;
    const auto append = [&](const std::vector<int>& nodes) {
        for (const int v : nodes) {
            values.push_back({v + 1, v < n_vertices ? of_vertex[v] : kNoCell});
        }
    };
    append(model.entities.points);
    for (const MshCurve& curve : model.entities.curves) append(inner_nodes(curve));
    for (const MshSurface& cell : model.entities.surfaces) append(cell.nodes);
    return values;
}

}  // namespace

std::vector<EncodedFile> encode_msh(const plane::Tile& tile, const std::string& path,
                                    const CellMaterials* materials,
                                    std::span<const int> site_orbits) {
    require_triangles(tile.kind, path);
    require_finite(tile);
    const SolverNodes nodes = solver_nodes(tile);
    const MshModel model = msh_model(tile, nodes, materials);
    std::string text;
    append_head(text, tile, model, site_orbits);
    append_entities(text, tile, model);
    append_nodes(text, nodes, model);
    append_elements(text, tile, nodes, model);
    append_periodic(text, tile, model);
    std::vector<int> values = element_cells(tile);
    append_msh_data(text, "ElementData", kCellView, element_values(tile, model, values));
    if (!tile.vertex_site.empty()) {
        append_msh_data(text, "NodeData", kCellView, node_values(model, tile.vertex_site));
    }
    if (!site_orbits.empty()) {
        for (int& value : values) value = site_orbits[value];
        append_msh_data(text, "ElementData", kOrbitView, element_values(tile, model, values));
    }
    return only_file(path, std::move(text));
}

}  // namespace pcvt
