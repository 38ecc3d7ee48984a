#include "io/forms/entity_mesh.hpp"

#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "io/forms/cell_entities.hpp"
#include "io/forms/material_words.hpp"
#include "io/forms/site_notes.hpp"
#include "io/forms/site_orbits.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

constexpr int kPoints = 0;
constexpr int kCurves = 1;
constexpr int kSurfaces = 2;

int count(const auto& list) { return static_cast<int>(list.size()); }

/// first, first + 1, ..., last - 1.
std::vector<int> range(int first, int last) {
    std::vector<int> numbers(static_cast<std::size_t>(last - first));
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
}

/// Divides triangles. Point and curve k have the tag k + 1, the surface of a cell has the tag
/// site + 1.
class TileDivision {
   public:
    TileDivision(const plane::Tile& tile, const CellMaterials* materials)
        : tile_(tile),
          nodes_(solver_nodes(tile)),
          entities_(cell_entities(tile, nodes_)),
          form_{.mesh = element_mesh(tile, nodes_)} {
        if (materials == nullptr) return;
        phases_.phase_names = materials->phase_names;
        phases_.site_phase = materials->site_phase;
    }

    EntityMesh divide(std::span<const int> site_orbits) {
        form_.listed = {kCurves, kSurfaces};
        form_.title = "A periodic tile";
        form_.kind = file_word(tile_.kind);
        append_note_comments(form_.notes, "pcvt ", tile_, 1);
        append_materials(form_.notes, "pcvt ", phases_);
        append_site_orbits(form_.notes, "pcvt ", site_orbits);
        add_groups();
        add_points();
        add_curves();
        add_surfaces();
        link_points();
        link_curves();
        if (site_orbits.empty()) return std::move(form_);
        for (const SiteId site : form_.mesh.element_site) {
            form_.element_orbit.push_back(site_orbits[site]);
        }
        return std::move(form_);
    }

   private:
    /// Names the groups of curves, of cells, and of phases.
    void add_groups() {
        for (const CellCurve& curve : entities_.curves) {
            if (curve.is_seam()) seam_groups_[curve.offset] = 0;
            if (curve.wall) wall_groups_[*curve.wall] = 0;
        }
        int number = entities_.surfaces.back().site + 1;
        for (auto& [offset, group] : seam_groups_) {
            group = ++number;
            form_.groups.push_back({kCurves, group, seam_name(offset)});
        }
        for (auto& [wall, group] : wall_groups_) {
            group = ++number;
            form_.groups.push_back({kCurves, group, wall_name(tile_, wall)});
        }
        boundary_group_ = ++number;
        if (!entities_.curves.back().bounds_tile()) {
            form_.groups.push_back({kCurves, boundary_group_, std::string(kGrainBoundarySet)});
        }
        first_phase_ = ++number;
        std::set<int> phases;
        for (const CellSurface& cell : entities_.surfaces) {
            form_.groups.push_back(
                {kSurfaces, cell.site + 1, std::string(kCellSet) + std::to_string(cell.site)});
            if (!phases_.empty()) phases.insert(phases_.site_phase[cell.site]);
        }
        for (const int phase : phases) {
            form_.groups.push_back(
                {kSurfaces, first_phase_ + phase, phase_group(phases_.phase_names[phase])});
        }
    }

    int group(const CellCurve& curve) const {
        if (curve.wall) return wall_groups_.at(*curve.wall);
        return curve.is_seam() ? seam_groups_.at(curve.offset) : boundary_group_;
    }

    void add_points() {
        point_tag_.assign(tile_.points.size(), 0);
        for (const int v : entities_.points) {
            point_tag_[v] = form_.entities[kPoints].size() + 1;
            form_.entities[kPoints].add(point_tag_[v], {}, {}, std::span(&v, 1), {});
        }
    }

    void add_curves() {
        ElementList& lines = form_.sides[kCurves];
        lines.kind = tile_.order == 2 ? ElementKind::kLine3 : ElementKind::kLine2;
        for (const CellCurve& curve : entities_.curves) {
            const int tag = form_.entities[kCurves].size() + 1;
            checkpoint_each(tag);
            const int first = lines.size();
            for (std::size_t k = 0; k + 1 < curve.vertices.size(); ++k) {
                std::vector<int>& nodes = lines.nodes.corners;
                nodes.insert(nodes.end(), {curve.vertices[k], curve.vertices[k + 1]});
                if (!curve.middles.empty()) nodes.push_back(curve.middles[k]);
                lines.nodes.close();
            }
            std::vector<int> inner(curve.vertices.begin() + 1, curve.vertices.end() - 1);
            inner.insert(inner.end(), curve.middles.begin(), curve.middles.end());
            const std::array ends{point_tag_[curve.vertices.front()],
                                  -point_tag_[curve.vertices.back()]};
            form_.entities[kCurves].add(tag, std::array{group(curve)}, ends, inner,
                                        range(first, lines.size()));
        }
    }

    void add_surfaces() {
        for (const CellSurface& cell : entities_.surfaces) {
            checkpoint_each(cell.site);
            std::vector<int> groups{cell.site + 1};
            if (!phases_.empty()) groups.push_back(first_phase_ + phases_.site_phase[cell.site]);
            std::vector<int> boundary;
            for (const int k : cell.left_of) boundary.push_back(k + 1);
            for (const int k : cell.right_of) boundary.push_back(-(k + 1));
            form_.entities[kSurfaces].add(cell.site + 1, groups, boundary, cell.nodes,
                                          cell.triangles);
        }
    }

    void add_link(int dimension, int slave, int master, plane::Offset offset,
                  std::vector<std::array<int, 2>> nodes) {
        const plane::Vec2 t = tile_.lattice.translation(offset);
        form_.links.push_back({dimension, slave, master, {t.x(), t.y(), 0}, std::move(nodes)});
    }

    /// Links each point to the image of it with the smallest offset, by the tags of the slaves.
    void link_points() {
        // The image with the smallest offset, by the representative.
        std::map<int, plane::VertexPair> masters;
        for (const plane::VertexPair& pair : tile_.vertex_pairs) {
            plane::VertexPair& master =
                masters.try_emplace(pair.v, plane::VertexPair{pair.v, pair.v, plane::Offset{}})
                    .first->second;
            if (pair.offset < master.offset) master = pair;
        }
        std::map<int, plane::VertexPair> links;
        const auto link = [&](int v, int representative, plane::Offset offset) {
            const plane::VertexPair& master = masters.at(representative);
            if (point_tag_[v] == 0 || v == master.w) return;
            links.emplace(point_tag_[v], plane::VertexPair{master.w, v, offset - master.offset});
        };
        for (const auto& [representative, master] : masters) {
            link(representative, representative, {});
        }
        for (const plane::VertexPair& pair : tile_.vertex_pairs) link(pair.w, pair.v, pair.offset);
        for (const auto& [point, pair] : links) {
            add_link(kPoints, point, point_tag_[pair.v], pair.offset, {{pair.w, pair.v}});
        }
    }

    void link_curves() {
        for (int k = 0; k < count(entities_.curves); ++k) {
            const CellCurve& slave = entities_.curves[k];
            if (!slave.is_seam() || !(slave.offset < plane::Offset{})) continue;
            const CellCurve& master = entities_.curves[slave.partner];
            std::vector<std::array<int, 2>> nodes;
            const auto add_pairs = [&](const std::vector<int>& of, const std::vector<int>& with) {
                for (std::size_t v = 0; v < of.size(); ++v) {
                    nodes.push_back({of[v], with[of.size() - 1 - v]});
                }
            };
            add_pairs(slave.vertices, master.vertices);
            add_pairs(slave.middles, master.middles);
            add_link(kCurves, k + 1, slave.partner + 1, master.offset, std::move(nodes));
        }
    }

    const plane::Tile& tile_;
    const SolverNodes nodes_;
    const CellEntities entities_;
    EntityMesh form_;
    /// The phases of the cells; empty without phases.
    CellMaterials phases_;
    /// The tag of the point at each vertex; 0: none.
    std::vector<int> point_tag_;
    std::map<plane::Offset, int> seam_groups_;
    std::map<plane::WallId, int> wall_groups_;
    int boundary_group_ = 0;
    int first_phase_ = 0;
};

}  // namespace

void EntityList::add(int tag, std::span<const int> of_groups, std::span<const int> of_boundary,
                     std::span<const int> of_nodes, std::span<const int> of_elements) {
    tags.push_back(tag);
    groups.add(of_groups);
    boundary.add(of_boundary);
    nodes.add(of_nodes);
    elements.add(of_elements);
}

EntityMesh entity_mesh(const plane::Tile& tile, const CellMaterials* materials,
                       std::span<const int> site_orbits) {
    return TileDivision(tile, materials).divide(site_orbits);
}

}  // namespace pcvt
