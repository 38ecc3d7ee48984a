#include "io/solvers/space_msh_writer.hpp"

#include <limits>
#include <map>
#include <utility>

#include "io/bytes/msh_text.hpp"
#include "io/forms/seam_entities.hpp"
#include "mesher/cells/set_names.hpp"
#include "mesher/space/mesh/polyhedral_mesh.hpp"

namespace pcvt {
namespace {

constexpr int kPoints = 0;
constexpr int kCurves = 1;
constexpr int kSurfaces = 2;
constexpr int kVolumes = 3;
/// Gmsh's element types.
constexpr int kSeamTriangle = 2;
/// The tag of the volume.
constexpr int kDomain = 1;

int count(const auto& list) { return static_cast<int>(list.size()); }

/// Appends one file. Point, curve and surface k have the tag k + 1; the physical group of a surface
/// has its tag, and that of the volume the next one.
class MshText {
   public:
    MshText(const space::TetrahedralMesh& mesh, const SeamEntities& entities)
        : mesh_(mesh), entities_(entities) {}

    std::string encode() {
        append_head();
        append_entities();
        append_nodes();
        append_elements();
        append_periodic();
        append_msh_data(text_, "NodeData", "cell_id", sites_);
        return std::move(text_);
    }

   private:
    void append_head() {
        text_ = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\n";
        text_ += "A periodic tile of tetrahedra, written by pcvt\n";
        text_ += std::string(kTetrahedraComment) + "\npcvt lattice ";
        for (const space::Vec3& period : mesh_.lattice.periods()) append_vector(period);
        text_.back() = '\n';
        text_ += "$EndComments\n$PhysicalNames\n";
        append_msh_line(text_, {count(entities_.surfaces) + 1});
        for (int k = 0; k < count(entities_.surfaces); ++k) {
            append_msh_name(text_, kSurfaces, k + 1, seam_name(entities_.surfaces[k].offset));
        }
        append_msh_name(text_, kVolumes, domain_group(), std::string(kDomainSet));
        text_ += "$EndPhysicalNames\n";
    }

    int domain_group() const { return count(entities_.surfaces) + 1; }

    void append_vector(const space::Vec3& v) { append_msh_words(text_, {v.x(), v.y(), v.z()}); }

    /// Appends the smallest box round the points of elements.
    template <std::size_t n>
    void append_bounds(const std::vector<std::array<int, n>>& elements) {
        space::Vec3 low = space::Vec3::Constant(std::numeric_limits<double>::infinity());
        space::Vec3 high = -low;
        for (const std::array<int, n>& element : elements) {
            for (const int v : element) {
                low = low.cwiseMin(mesh_.points[v]);
                high = high.cwiseMax(mesh_.points[v]);
            }
        }
        append_vector(low);
        append_vector(high);
    }

    void append_entities() {
        text_ += "$Entities\n";
        append_msh_line(text_, {count(entities_.points), count(entities_.curves),
                                count(entities_.surfaces), kDomain});
        std::vector<int> tag_of(mesh_.points.size(), 0);
        for (int k = 0; k < count(entities_.points); ++k) {
            const int v = entities_.points[k].point;
            tag_of[v] = k + 1;
            append_msh_words(text_, {k + 1});
            append_vector(mesh_.points[v]);
            append_msh_line(text_, {0});
        }
        std::vector<std::vector<int>> curves_of(entities_.surfaces.size());
        for (int k = 0; k < count(entities_.curves); ++k) {
            const SeamCurve& curve = entities_.curves[k];
            for (const int surface : curve.surfaces) curves_of[surface].push_back(k + 1);
            append_msh_words(text_, {k + 1});
            append_bounds(curve.edges);
            append_msh_words(text_, {0, count(curve.ends)});
            for (const int v : curve.ends) append_msh_words(text_, {tag_of[v]});
            text_.back() = '\n';
        }
        for (int k = 0; k < count(entities_.surfaces); ++k) {
            append_msh_words(text_, {k + 1});
            append_bounds(entities_.surfaces[k].triangles);
            append_msh_words(text_, {1, k + 1, count(curves_of[k])});
            for (const int tag : curves_of[k]) append_msh_words(text_, {tag});
            text_.back() = '\n';
        }
        append_msh_words(text_, {kDomain});
        append_bounds(mesh_.tetrahedra);
        append_msh_words(text_, {1, domain_group(), count(entities_.surfaces)});
        for (int k = 0; k < count(entities_.surfaces); ++k) append_msh_words(text_, {k + 1});
        text_.back() = '\n';
        text_ += "$EndEntities\n";
    }

    /// Appends the points that an entity alone has; nothing where it has none.
    void append_block(int dimension, int entity, const std::vector<int>& points) {
        if (points.empty()) return;
        append_msh_line(text_, {dimension, entity, 0, count(points)});
        for (const int v : points) {
            append_msh_line(text_, {v + 1});
            sites_.push_back({v + 1, mesh_.point_site[v]});
        }
        for (const int v : points) {
            append_vector(mesh_.points[v]);
            text_.back() = '\n';
        }
    }

    void append_nodes() {
        int n_blocks = count(entities_.points) + (entities_.inner_points.empty() ? 0 : 1);
        for (const SeamCurve& curve : entities_.curves) n_blocks += curve.points.empty() ? 0 : 1;
        for (const SeamSurface& surface : entities_.surfaces) {
            n_blocks += surface.points.empty() ? 0 : 1;
        }
        text_ += "$Nodes\n";
        append_msh_line(text_, {n_blocks, mesh_.n_points(), 1, mesh_.n_points()});
        for (int k = 0; k < count(entities_.points); ++k) {
            append_block(kPoints, k + 1, {entities_.points[k].point});
        }
        for (int k = 0; k < count(entities_.curves); ++k) {
            append_block(kCurves, k + 1, entities_.curves[k].points);
        }
        for (int k = 0; k < count(entities_.surfaces); ++k) {
            append_block(kSurfaces, k + 1, entities_.surfaces[k].points);
        }
        append_block(kVolumes, kDomain, entities_.inner_points);
        text_ += "$EndNodes\n";
    }

    /// Appends the elements of an entity, with the numbers after `last`.
    template <std::size_t n>
    void append_elements_of(int dimension, int entity, int type,
                            const std::vector<std::array<int, n>>& elements, int& last) {
        append_msh_line(text_, {dimension, entity, type, count(elements)});
        for (const std::array<int, n>& element : elements) {
            append_msh_words(text_, {++last});
            for (const int v : element) append_msh_words(text_, {v + 1});
            text_.back() = '\n';
        }
    }

    void append_elements() {
        int n_elements = mesh_.n_tetrahedra();
        for (const SeamSurface& surface : entities_.surfaces) {
            n_elements += count(surface.triangles);
        }
        text_ += "$Elements\n";
        append_msh_line(text_, {1 + count(entities_.surfaces), n_elements, 1, n_elements});
        int last = 0;
        append_elements_of(kVolumes, kDomain, kMshTetrahedron, mesh_.tetrahedra, last);
        for (int k = 0; k < count(entities_.surfaces); ++k) {
            append_elements_of(kSurfaces, k + 1, kSeamTriangle, entities_.surfaces[k].triangles, last);
        }
        text_ += "$EndElements\n";
    }

    /// Appends a link, with the pairs of points of the elements of slave and master.
    /// @param turned  whether the elements are traversed in opposite orders from their first point.
    template <std::size_t n>
    void append_link(int dimension, int slave, int master, space::Offset offset,
                     const std::vector<std::array<int, n>>& slaves,
                     const std::vector<std::array<int, n>>& masters, bool turned) {
        std::map<int, int> master_of;
        for (std::size_t e = 0; e < slaves.size(); ++e) {
            for (std::size_t k = 0; k < n; ++k) {
                master_of[slaves[e][k]] = masters[e][turned ? (n - k) % n : k];
            }
        }
        const space::Vec3 t = mesh_.lattice.translation(offset);
        append_msh_link(text_, dimension, slave + 1, master + 1, {t.x(), t.y(), t.z()},
                        master_of.size());
        for (const auto& [of, v] : master_of) append_msh_line(text_, {of + 1, v + 1});
    }

    void append_periodic() {
        int n_links = count(entities_.surfaces) / 2;
        for (int k = 0; k < count(entities_.curves); ++k) {
            n_links += entities_.curves[k].master == k ? 0 : 1;
        }
        for (int k = 0; k < count(entities_.points); ++k) {
            n_links += entities_.points[k].master == k ? 0 : 1;
        }
        text_ += "$Periodic\n";
        append_msh_line(text_, {n_links});
        using Single = std::vector<std::array<int, 1>>;
        for (int k = 0; k < count(entities_.points); ++k) {
            const auto& [point, master, offset] = entities_.points[k];
            if (master == k) continue;
            append_link(kPoints, k, master, offset, Single{{point}},
                        Single{{entities_.points[master].point}}, false);
        }
        for (int k = 0; k < count(entities_.curves); ++k) {
            const SeamCurve& curve = entities_.curves[k];
            if (curve.master == k) continue;
            append_link(kCurves, k, curve.master, curve.offset, curve.edges,
                        entities_.curves[curve.master].edges, false);
        }
        for (int k = 1; k < count(entities_.surfaces); k += 2) {
            const SeamSurface& slave = entities_.surfaces[k];
            append_link(kSurfaces, k, slave.partner, -slave.offset, slave.triangles,
                        entities_.surfaces[slave.partner].triangles, true);
        }
        text_ += "$EndPeriodic\n";
    }

    const space::TetrahedralMesh& mesh_;
    const SeamEntities& entities_;
    std::string text_;
    /// The site of each node, in the order of $Nodes.
    std::vector<MshValue> sites_ = {};
};

}  // namespace

std::vector<EncodedFile> encode_space_msh(const space::TetrahedralMesh& mesh,
                                          const std::string& path) {
    const SeamEntities entities = seam_entities(mesh, prove_tetrahedra(mesh));
    return only_file(path, MshText(mesh, entities).encode());
}

}  // namespace pcvt
