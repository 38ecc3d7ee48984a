#include "mesher/tile/site_positions.hpp"

#include <algorithm>
#include <cmath>

namespace pcvt {
namespace {

/// Returns the position of the owner of each entry of tile.sites(); empty if not known.
const std::vector<Vec2>& owner_positions(const Tile& tile) {
    switch (tile.kind) {
        case MeshKind::kVoronoi:
            return tile.site_points;
        case MeshKind::kGrains:
            return tile.grain_site_points;
        case MeshKind::kDelaunay:
            break;
    }
    return tile.points;
}

}  // namespace

std::vector<Vec2> site_positions(const Tile& tile) {
    if (!tile.site_positions.empty()) return tile.site_positions;
    const std::vector<SiteId>& sites = tile.sites();
    const std::vector<Vec2>& owners = owner_positions(tile);
    if (tile.columns == 0 || sites.empty() || owners.size() != sites.size()) return {};
    const auto [least, most] = std::minmax_element(sites.begin(), sites.end());
    if (*least < 0 || static_cast<std::size_t>(*most) >= sites.size()) return {};
    std::vector<Vec2> positions(static_cast<std::size_t>(*most) + 1);
    // The first owner of a site has the last word.
    for (std::size_t k = sites.size(); k-- > 0;) positions[sites[k]] = owners[k];
    return positions;
}

std::vector<Vec2> nearest_site_images(const Tile& tile) {
    if (tile.kind != MeshKind::kGrains || tile.site_positions.empty()) return {};
    const Lattice& lattice = tile.lattice;
    const Lattice of_sites =
        reduce(Lattice(lattice.a() / tile.columns, lattice.b() / tile.rows)).reduced;
    std::vector<Vec2> images;
    images.reserve(tile.face_site.size());
    for (int f = 0; f < tile.n_faces(); ++f) {
        Vec2 middle(0, 0);
        for (const int v : tile.faces[f]) middle += tile.points[v] / tile.face_size(f);
        const Vec2& site = tile.site_positions[tile.face_site[f]];
        const Vec2 u = of_sites.to_lattice(middle - site);
        const Offset about{static_cast<int>(std::lround(u.x())),
                           static_cast<int>(std::lround(u.y()))};
        Vec2 best = site + of_sites.translation(about);
        for (int i = -1; i <= 1; ++i) {
            for (int j = -1; j <= 1; ++j) {
                const Vec2 image = site + of_sites.translation(about + Offset{i, j});
                if ((image - middle).squaredNorm() < (best - middle).squaredNorm()) best = image;
            }
        }
        images.push_back(best);
    }
    return images;
}

}  // namespace pcvt
