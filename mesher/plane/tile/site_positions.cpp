#include "mesher/plane/tile/site_positions.hpp"

#include <algorithm>

namespace pcvt::plane {
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

std::vector<Vec2> grain_site_points(const Tile& tile, const std::vector<Offset>& images) {
    if (tile.kind != MeshKind::kGrains || tile.site_positions.empty() || images.empty()) return {};
    const Lattice of_sites(tile.lattice.a() / tile.columns, tile.lattice.b() / tile.rows);
    std::vector<Vec2> points;
    points.reserve(images.size());
    for (int f = 0; f < tile.n_faces(); ++f) {
        points.push_back(tile.site_positions[tile.face_site[f]] + of_sites.translation(images[f]));
    }
    return points;
}

}  // namespace pcvt::plane
