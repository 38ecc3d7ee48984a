#include "io/forms/seam_entities.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace pcvt {
namespace {

using Edge = std::array<int, 2>;

/// An edge of the boundary, as one of the images of an orbit.
struct EdgeImage {
    space::Offset offset;
    /// In the order of their sites, which is that of all images.
    Edge edge;
    /// The surface of each triangle at the edge, rising.
    std::vector<int> uses;

    bool lies_in_one_surface() const { return uses.size() == 2 && uses[0] == uses[1]; }
};

/// The translations from the first image of an edge to each image, and the surfaces that meet
/// there: edges with equal signatures are on the same curves.
using Signature = std::vector<std::pair<space::Offset, std::vector<int>>>;

/// The surfaces and curves that meet at a point of the boundary.
struct PointUse {
    std::set<int> surfaces = {};
    /// The curve of each edge.
    std::vector<int> curves = {};
};

enum class PointKind { kInSurface, kInCurve, kPoint };

std::vector<int> without_repeats(std::vector<int> numbers) {
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

class SeamDivision {
   public:
    explicit SeamDivision(const space::TetrahedralMesh& mesh) : mesh_(mesh) {}

    SeamEntities divide(const std::vector<space::TrianglePair>& pairs) {
        make_surfaces(pairs);
        make_curves();
        place_points();
        return std::move(entities_);
    }

   private:
    void make_surfaces(const std::vector<space::TrianglePair>& pairs) {
        std::map<space::Offset, std::vector<const space::TrianglePair*>> by_offset;
        for (const space::TrianglePair& pair : pairs) by_offset[pair.offset].push_back(&pair);
        for (const auto& [offset, members] : by_offset) {
            const int first = static_cast<int>(entities_.surfaces.size());
            SeamSurface here{.offset = offset, .partner = first + 1};
            SeamSurface there{.offset = -offset, .partner = first};
            for (const space::TrianglePair* const pair : members) {
                const auto& [u, v, w] = pair->second;
                here.triangles.push_back(pair->first);
                there.triangles.push_back({u, w, v});
            }
            entities_.surfaces.push_back(std::move(here));
            entities_.surfaces.push_back(std::move(there));
        }
    }

    /// The edges of the boundary by their orbits.
    std::map<std::array<space::Corner, 2>, std::vector<EdgeImage>> edge_orbits() {
        std::map<Edge, std::vector<int>> uses;
        for (int k = 0; k < static_cast<int>(entities_.surfaces.size()); ++k) {
            for (const auto& triangle : entities_.surfaces[k].triangles) {
                for (std::size_t i = 0; i < 3; ++i) {
                    Edge edge{triangle[i], triangle[(i + 1) % 3]};
                    if (mesh_.corner(edge[1]) < mesh_.corner(edge[0])) {
                        std::swap(edge[0], edge[1]);
                    }
                    uses[edge].push_back(k);
                    uses_of_[triangle[i]].surfaces.insert(k);
                }
            }
        }
        std::map<std::array<space::Corner, 2>, std::vector<EdgeImage>> orbits;
        for (auto& [edge, surfaces] : uses) {
            const auto [site, offset] = mesh_.corner(edge[0]);
            const space::Corner end = mesh_.corner(edge[1]);
            orbits[{space::Corner{site, {}}, space::Corner{end.site, end.offset - offset}}]
                .push_back({offset, edge, std::move(surfaces)});
        }
        return orbits;
    }

    void make_curves() {
        std::map<Signature, std::vector<std::vector<EdgeImage>>> groups;
        for (auto& [orbit, images] : edge_orbits()) {
            if (std::all_of(images.begin(), images.end(),
                            [](const EdgeImage& image) { return image.lies_in_one_surface(); })) {
                continue;
            }
            std::sort(images.begin(), images.end(),
                      [](const EdgeImage& s, const EdgeImage& t) { return s.offset < t.offset; });
            Signature signature;
            for (const EdgeImage& image : images) {
                signature.emplace_back(image.offset - images.front().offset, image.uses);
            }
            groups[signature].push_back(std::move(images));
        }
        for (const auto& [signature, orbits] : groups) {
            const int master = static_cast<int>(entities_.curves.size());
            for (std::size_t k = 0; k < signature.size(); ++k) {
                const int curve = static_cast<int>(entities_.curves.size());
                entities_.curves.push_back({.master = master,
                                            .offset = signature[k].first,
                                            .surfaces = without_repeats(signature[k].second)});
                for (const std::vector<EdgeImage>& images : orbits) {
                    entities_.curves.back().edges.push_back(images[k].edge);
                    for (const int v : images[k].edge) uses_of_[v].curves.push_back(curve);
                }
            }
        }
    }

    /// The kind of a point by the surfaces and curves that meet there.
    PointKind own_kind(const PointUse& use) const {
        if (use.curves.empty()) {
            return use.surfaces.size() == 1 ? PointKind::kInSurface : PointKind::kPoint;
        }
        const int curve = use.curves.front();
        const bool passes = use.curves.size() == 2 && use.curves[1] == curve &&
                            std::equal(use.surfaces.begin(), use.surfaces.end(),
                                       entities_.curves[curve].surfaces.begin(),
                                       entities_.curves[curve].surfaces.end());
        return passes ? PointKind::kInCurve : PointKind::kPoint;
    }

    /// The kind of all images of each site that lie on the boundary.
    std::map<SiteId, PointKind> kinds() const {
        std::map<SiteId, PointKind> kinds;
        for (const auto& [v, use] : uses_of_) {
            const PointKind kind = own_kind(use);
            const auto [found, is_new] = kinds.emplace(mesh_.point_site[v], kind);
            if (!is_new && found->second != kind) found->second = PointKind::kPoint;
        }
        return kinds;
    }

    void place_points() {
        const std::map<SiteId, PointKind> kind_of = kinds();
        std::map<SiteId, int> first;
        for (int v = 0; v < mesh_.n_points(); ++v) {
            const auto found = uses_of_.find(v);
            if (found == uses_of_.end()) {
                entities_.inner_points.push_back(v);
                continue;
            }
            const PointUse& use = found->second;
            const PointKind kind = kind_of.at(mesh_.point_site[v]);
            if (kind == PointKind::kInSurface) {
                entities_.surfaces[*use.surfaces.begin()].points.push_back(v);
            } else if (kind == PointKind::kInCurve) {
                entities_.curves[use.curves.front()].points.push_back(v);
            } else {
                const int entity = static_cast<int>(entities_.points.size());
                const int master = first.emplace(mesh_.point_site[v], entity).first->second;
                const int of = master == entity ? v : entities_.points[master].point;
                entities_.points.push_back(
                    {v, master, mesh_.point_offset[v] - mesh_.point_offset[of]});
                for (const int curve : use.curves) add_end(curve, v);
            }
        }
    }

    void add_end(int curve, int v) {
        std::vector<int>& ends = entities_.curves[curve].ends;
        if (std::find(ends.begin(), ends.end(), v) == ends.end()) ends.push_back(v);
    }

    const space::TetrahedralMesh& mesh_;
    SeamEntities entities_;
    /// The uses of each point of the boundary.
    std::map<int, PointUse> uses_of_;
};

}  // namespace

SeamEntities seam_entities(const space::TetrahedralMesh& mesh,
                           const space::TetrahedralProof& proof) {
    return SeamDivision(mesh).divide(proof.pairs);
}

}  // namespace pcvt
