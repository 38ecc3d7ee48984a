#include "io/forms/tetrahedra_entities.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "io/forms/seam_entities.hpp"
#include "mesher/cells/set_names.hpp"

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
/// surface has its tag, and that of the domain the next one; those of cells follow.
class TetrahedraDivision {
   public:
    explicit TetrahedraDivision(const space::TetrahedralMesh& mesh)
        : mesh_(mesh),
          entities_(seam_entities(mesh, prove_tetrahedra(mesh))),
          form_{.mesh = element_mesh(mesh)} {}

    EntityMesh divide() {
        form_.listed = {kVolumesInSpace, kSurfacesInSpace};
        form_.title = "A periodic tile of tetrahedra";
        form_.kind = kTetrahedraKind;
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
            form_.entities[kPointsInSpace].add(k + 1, {}, {}, std::span(&v, 1), {});
        }
    }

    /// Adds elements to those of a dimension; returns their indices.
    template <std::size_t n>
    std::vector<int> added_sides(int dimension, const std::vector<std::array<int, n>>& elements) {
        ElementList& sides = form_.sides[dimension];
        const int first = sides.size();
        for (const std::array<int, n>& element : elements) sides.nodes.add(element);
        return numbers_from(first, sides.size());
    }

    void add_curves() {
        form_.sides[kCurvesInSpace].kind = ElementKind::kLine2;
        curves_of_.resize(entities_.surfaces.size());
        for (int k = 0; k < length_of(entities_.curves); ++k) {
            const SeamCurve& curve = entities_.curves[k];
            for (const int surface : curve.surfaces) curves_of_[surface].push_back(k + 1);
            std::vector<int> ends;
            for (const int v : curve.ends) ends.push_back(point_tag_[v]);
            form_.entities[kCurvesInSpace].add(k + 1, {}, ends, curve.points,
                                               added_sides(kCurvesInSpace, curve.edges));
        }
    }

    void add_surfaces() {
        form_.sides[kSurfacesInSpace].kind = ElementKind::kTriangle3;
        for (int k = 0; k < length_of(entities_.surfaces); ++k) {
            const SeamSurface& surface = entities_.surfaces[k];
            form_.groups.push_back({kSurfacesInSpace, k + 1, seam_name(surface.offset)});
            form_.entities[kSurfacesInSpace].add(k + 1, std::array{k + 1}, curves_of_[k],
                                                 surface.points,
                                                 added_sides(kSurfacesInSpace, surface.triangles));
        }
    }

    void add_volume() {
        const int n = length_of(entities_.surfaces);
        form_.groups.push_back({kVolumesInSpace, n + 1, std::string(kDomainSet)});
        if (mesh_.cell.empty()) {
            form_.entities[kVolumesInSpace].add(1, std::array{n + 1}, numbers_from(1, n + 1),
                                                entities_.inner_points,
                                                numbers_from(0, mesh_.n_tetrahedra()));
        } else {
            add_cells(n + 1);
        }
    }

    /// Adds the cells as volumes, in the group of the domain and in one of their own. Their faces
    /// inside of the tile are not surfaces, so that volumes state no boundary; the points of such a
    /// face belong to the first of its cells.
    void add_cells(int domain) {
        const int n_cells = mesh_.cell.back() + 1;
        std::vector<char> is_waiting(mesh_.points.size(), 0);
        for (const int v : entities_.inner_points) is_waiting[v] = 1;
        for (int s = 0, t = 0; s < n_cells; ++s) {
            const int first = t;
            std::vector<int> inner;
            for (; t < mesh_.n_tetrahedra() && mesh_.cell[t] == s; ++t) {
                for (const int v : mesh_.tetrahedra[t]) {
                    if (std::exchange(is_waiting[v], 0) != 0) inner.push_back(v);
                }
            }
            std::sort(inner.begin(), inner.end());
            const int group = domain + 1 + s;
            form_.groups.push_back(
                {kVolumesInSpace, group, std::string(kCellSet) + std::to_string(s)});
            form_.entities[kVolumesInSpace].add(s + 1, std::array{domain, group}, {}, inner,
                                                numbers_from(first, t));
        }
    }

    /// Adds a link, with the pairs of points of the elements of slave and master.
    /// @param turned  whether the elements are traversed in opposite orders from their first point.
    template <std::size_t n>
    void add_link(int dimension, int slave, int master, space::Offset offset,
                  const std::vector<std::array<int, n>>& slaves,
                  const std::vector<std::array<int, n>>& masters, bool turned) {
        std::map<int, int> master_of;
        for (std::size_t e = 0; e < slaves.size(); ++e) {
            for (std::size_t k = 0; k < n; ++k) {
                master_of[slaves[e][k]] = masters[e][turned ? (n - k) % n : k];
            }
        }
        const space::Vec3 t = mesh_.lattice.translation(offset);
        EntityLink link{dimension, slave + 1, master + 1, {t.x(), t.y(), t.z()}};
        for (const auto& [of, v] : master_of) link.nodes.push_back({of, v});
        form_.links.push_back(std::move(link));
    }

    void add_links() {
        using Single = std::vector<std::array<int, 1>>;
        for (int k = 0; k < length_of(entities_.points); ++k) {
            const auto& [point, master, offset] = entities_.points[k];
            if (master == k) continue;
            add_link(kPointsInSpace, k, master, offset, Single{{point}},
                     Single{{entities_.points[master].point}}, false);
        }
        for (int k = 0; k < length_of(entities_.curves); ++k) {
            const SeamCurve& curve = entities_.curves[k];
            if (curve.master == k) continue;
            add_link(kCurvesInSpace, k, curve.master, curve.offset, curve.edges,
                     entities_.curves[curve.master].edges, false);
        }
        for (int k = 1; k < length_of(entities_.surfaces); k += 2) {
            const SeamSurface& slave = entities_.surfaces[k];
            add_link(kSurfacesInSpace, k, slave.partner, -slave.offset, slave.triangles,
                     entities_.surfaces[slave.partner].triangles, true);
        }
    }

    const space::TetrahedralMesh& mesh_;
    const SeamEntities entities_;
    EntityMesh form_;
    /// The tag of each point of the mesh that is an entity of the boundary; 0: none.
    std::vector<int> point_tag_;
    /// The tags of the curves of each surface.
    std::vector<std::vector<int>> curves_of_;
};

}  // namespace

EntityMesh entity_mesh(const space::TetrahedralMesh& mesh) {
    return TetrahedraDivision(mesh).divide();
}

}  // namespace pcvt
