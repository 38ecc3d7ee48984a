#include "mesher/tile/site_positions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

Vec2 face_middle(const Tile& tile, int f) {
    Vec2 sum(0, 0);
    for (const int v : tile.faces[f]) sum += tile.points[v];
    return sum / tile.face_size(f);
}

std::vector<Vec2> nearest_site_images(const Tile& tile) {
    if (tile.kind != MeshKind::kGrains || tile.site_positions.empty()) return {};
    // The cell lies in the Voronoi cell of its site among the images of that site, in the metric.
    const Lattice& lattice = tile.lattice;
    const Metric& metric = tile.metric;
    const Lattice of_sites(lattice.a() / tile.columns, lattice.b() / tile.rows);
    const Reduction reduction = reduce(metric.to_round(of_sites));
    std::vector<Vec2> images;
    images.reserve(tile.face_site.size());
    for (int f = 0; f < tile.n_faces(); ++f) {
        const Vec2 middle = face_middle(tile, f);
        const Vec2& site = tile.site_positions[tile.face_site[f]];
        const Vec2 u = reduction.reduced.to_lattice(metric.to_round(Vec2(middle - site)));
        const Offset about{static_cast<int>(std::lround(u.x())),
                           static_cast<int>(std::lround(u.y()))};
        double least = std::numeric_limits<double>::infinity();
        Vec2 best = site;
        for (int i = -1; i <= 1; ++i) {
            for (int j = -1; j <= 1; ++j) {
                const Offset offset = reduction.to_original(about + Offset{i, j});
                const Vec2 image = site + of_sites.translation(offset);
                const double distance = metric.to_round(Vec2(image - middle)).squaredNorm();
                if (!(distance < least)) continue;
                least = distance;
                best = image;
            }
        }
        images.push_back(best);
    }
    return images;
}

}  // namespace pcvt
