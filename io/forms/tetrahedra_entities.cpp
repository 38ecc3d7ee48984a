#include "io/forms/tetrahedra_entities.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "io/forms/material_words.hpp"
#include "io/forms/seam_entities.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/space/mesh/midside_nodes.hpp"

namespace pcvt {
namespace {

constexpr int kPointsInSpace = 0;
constexpr int kCurvesInSpace = 1;
constexpr int kSurfacesInSpace = 2;
constexpr int kVolumesInSpace = 3;

int length_of(const auto& list) { return static_cast<int>(list.size()); }

/// first, first + 1, ..., last - 1.
std::vector<int> numbers_from(int first, int last) {
    std::vector<int> numbers(static_cast<std::size_t>(last - first));
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
}

/// Divides tetrahedra. Point, curve and surface k have the tag k + 1; the physical group of a
/// surface has its tag, and that of the domain the next one; those of cells and of phases follow.
class TetrahedraDivision {
   public:
    TetrahedraDivision(const space::TetrahedralMesh& mesh, const CellMaterials* materials)
        : mesh_(mesh),
          entities_(seam_entities(mesh, prove_tetrahedra(mesh))),
          form_{.mesh = element_mesh(mesh)} {
        if (materials != nullptr && !mesh.cell.empty()) {
            phases_.phase_names = materials->phase_names;
            phases_.site_phase = materials->site_phase;
        }
        is_waiting_.assign(form_.mesh.nodes.size(), 1);
    }

    EntityMesh divide() {
        form_.listed = {kVolumesInSpace, kSurfacesInSpace};
        form_.title = "A periodic tile of tetrahedra";
        form_.kind = kTetrahedraKind;
        append_materials(form_.notes, "pcvt ", phases_);
        find_middles();
        add_points();
        add_curves();
        add_surfaces();
        add_volume();
        add_links();
        return std::move(form_);
    }

   private:
    void add_points() {
        point_tag_.assign(mesh_.points.size(), 0);
        for (int k = 0; k < length_of(entities_.points); ++k) {
            const int v = entities_.points[k].point;
            point_tag_[v] = k + 1;
            is_waiting_[v] = 0;
            form_.entities[kPointsInSpace].add(k + 1, {}, {}, std::span(&v, 1), {});
        }
    }

    /// Finds the nodes in the middle of edges, by the ends of these.
    void find_middles() {
        const ElementList& elements = form_.mesh.elements;
        if (elements.kind != ElementKind::kTetrahedron10) return;
        for (const SeamSurface& surface : entities_.surfaces) {
            for (const auto& [u, v, w] : surface.triangles) {
                for (const auto& edge : {std::minmax(u, v), std::minmax(v, w), std::minmax(w, u)}) {
                    middles_[edge] = -1;
                }
            }
        }
        for (int t = 0; t < elements.size(); ++t) {
            checkpoint_each(t);
            const auto nodes = elements.nodes[t];
            for (std::size_t k = 0; k < space::kEdgeCorners.size(); ++k) {
                const auto& [i, j] = space::kEdgeCorners[k];
                const auto found = middles_.find(std::minmax(nodes[i], nodes[j]));
                if (found != middles_.end()) found->second = nodes[4 + k];
            }
        }
    }

    /// Adds elements to those of a dimension, with the nodes in the middle of their edges; returns
    /// their indices.
    template <std::size_t n>
    std::vector<int> added_sides(int dimension, const std::vector<std::array<int, n>>& elements) {
        ElementList& sides = form_.sides[dimension];
        const int first = sides.size();
        const std::size_t n_edges = middles_.empty() ? 0 : n == 2 ? 1 : n;
        for (const std::array<int, n>& element : elements) {
            std::vector<int> nodes(element.begin(), element.end());
            for (std::size_t k = 0; k < n_edges; ++k) {
                nodes.push_back(middles_.at(std::minmax(element[k], element[(k + 1) % n])));
            }
            sides.nodes.add(nodes);
        }
        return numbers_from(first, sides.size());
    }

    /// Adds an entity with the nodes of its elements that lie on no earlier entity.
    void add_entity(int dimension, int tag, std::span<const int> groups,
                    std::span<const int> boundary, const std::vector<int>& elements) {
        const Faces& nodes = form_.elements(dimension).nodes;
        std::vector<int> inner;
        for (const int e : elements) {
            for (const int v : nodes[e]) {
                if (std::exchange(is_waiting_[v], 0) != 0) inner.push_back(v);
            }
        }
        std::sort(inner.begin(), inner.end());
        form_.entities[dimension].add(tag, groups, boundary, inner, elements);
    }

    void add_curves() {
        form_.sides[kCurvesInSpace].kind =
            middles_.empty() ? ElementKind::kLine2 : ElementKind::kLine3;
        curves_of_.resize(entities_.surfaces.size());
        for (int k = 0; k < length_of(entities_.curves); ++k) {
            const SeamCurve& curve = entities_.curves[k];
            for (const int surface : curve.surfaces) curves_of_[surface].push_back(k + 1);
            std::vector<int> ends;
            for (const int v : curve.ends) ends.push_back(point_tag_[v]);
            add_entity(kCurvesInSpace, k + 1, {}, ends, added_sides(kCurvesInSpace, curve.edges));
        }
    }

    void add_surfaces() {
        form_.sides[kSurfacesInSpace].kind =
            middles_.empty() ? ElementKind::kTriangle3 : ElementKind::kTriangle6;
        for (int k = 0; k < length_of(entities_.surfaces); ++k) {
            const SeamSurface& surface = entities_.surfaces[k];
            form_.groups.push_back({kSurfacesInSpace, k + 1, seam_name(surface.offset)});
            add_entity(kSurfacesInSpace, k + 1, std::array{k + 1}, curves_of_[k],
                       added_sides(kSurfacesInSpace, surface.triangles));
        }
    }

    void add_volume() {
        const int n = length_of(entities_.surfaces);
        form_.groups.push_back({kVolumesInSpace, n + 1, std::string(kDomainSet)});
        if (mesh_.cell.empty()) {
            add_entity(kVolumesInSpace, 1, std::array{n + 1}, numbers_from(1, n + 1),
                       numbers_from(0, mesh_.n_tetrahedra()));
        } else {
            add_cells(n + 1);
        }
    }

    /// Adds the cells as volumes, in the group of the domain, in one of their own and in that of
    /// their phase. Their faces inside of the tile are not surfaces, so that volumes state no
    /// boundary; the points of such a face belong to the first of its cells.
    void add_cells(int domain) {
        const int n_cells = mesh_.cell.back() + 1;
        const int first_phase = domain + 1 + n_cells;
        for (int s = 0, t = 0; s < n_cells; ++s) {
            checkpoint_each(s);
            const int first = t;
            while (t < mesh_.n_tetrahedra() && mesh_.cell[t] == s) ++t;
            std::vector<int> groups{domain, domain + 1 + s};
            form_.groups.push_back(
                {kVolumesInSpace, groups.back(), std::string(kCellSet) + std::to_string(s)});
            if (!phases_.empty()) groups.push_back(first_phase + phases_.site_phase[s]);
            add_entity(kVolumesInSpace, s + 1, groups, {}, numbers_from(first, t));
        }
        const std::set<int> phases(phases_.site_phase.begin(), phases_.site_phase.end());
        for (const int phase : phases) {
            form_.groups.push_back(
                {kVolumesInSpace, first_phase + phase, phase_group(phases_.phase_names[phase])});
        }
    }

    /// Adds a link, with the pairs of nodes of the elements of slave and master. Triangles are
    /// traversed in opposite orders from their first point.
    void add_link(int dimension, int slave, int master, space::Offset offset) {
        const EntityList& entities = form_.entities[dimension];
        const Faces& nodes = form_.elements(dimension).nodes;
        std::map<int, int> master_of;
        for (int e = 0; e < entities.elements.size(slave); ++e) {
            const auto of_slave = nodes[entities.elements[slave][e]];
            const auto of_master = nodes[entities.elements[master][e]];
            const bool turned = dimension == kSurfacesInSpace;
            for (std::size_t k = 0; k < of_slave.size(); ++k) {
                master_of[of_slave[k]] = of_master[turned ? kTurned[k] : k];
            }
        }
        link(dimension, slave, master, offset, master_of);
    }

    void link(int dimension, int slave, int master, space::Offset offset,
              const std::map<int, int>& master_of) {
        const space::Vec3 t = mesh_.lattice.translation(offset);
        EntityLink link{dimension, slave + 1, master + 1, {t.x(), t.y(), t.z()}};
        for (const auto& [of, v] : master_of) link.nodes.push_back({of, v});
        form_.links.push_back(std::move(link));
    }

    void add_links() {
        for (int k = 0; k < length_of(entities_.points); ++k) {
            const auto& [point, master, offset] = entities_.points[k];
            if (master == k) continue;
            link(kPointsInSpace, k, master, offset, {{point, entities_.points[master].point}});
        }
        for (int k = 0; k < length_of(entities_.curves); ++k) {
            const SeamCurve& curve = entities_.curves[k];
            if (curve.master != k) add_link(kCurvesInSpace, k, curve.master, curve.offset);
        }
        for (int k = 1; k < length_of(entities_.surfaces); k += 2) {
            const SeamSurface& slave = entities_.surfaces[k];
            add_link(kSurfacesInSpace, k, slave.partner, -slave.offset);
        }
    }

    /// The nodes of a triangle that is traversed backwards from its first corner.
    static constexpr std::array<std::size_t, 6> kTurned{0, 2, 1, 5, 4, 3};

    const space::TetrahedralMesh& mesh_;
    const SeamEntities entities_;
    EntityMesh form_;
    /// The phases of the cells; empty without phases.
    CellMaterials phases_;
    /// The nodes in the middle of the edges of the boundary, by the ends of these; empty for order
    /// 1.
    std::map<std::pair<int, int>, int> middles_;
    /// Whether each node lies on no entity so far.
    std::vector<char> is_waiting_;
    /// The tag of each point of the mesh that is an entity of the boundary; 0: none.
    std::vector<int> point_tag_;
    /// The tags of the curves of each surface.
    std::vector<std::vector<int>> curves_of_;
};

}  // namespace

EntityMesh entity_mesh(const space::TetrahedralMesh& mesh, const CellMaterials* materials) {
    return TetrahedraDivision(mesh, materials).divide();
}

}  // namespace pcvt
