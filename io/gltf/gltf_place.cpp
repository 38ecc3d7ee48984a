#include "io/gltf/gltf_place.hpp"

#include "mesher/tile/texture_coordinates.hpp"

namespace pcvt {

Vec2 gltf_translation(const Tile& tile) { return tile.lattice.to_plane(distant_periods(tile)); }

Tile moved_by(Tile tile, const Vec2& way) {
    for (std::vector<Vec2>* points :
         {&tile.points, &tile.site_points, &tile.grain_site_points, &tile.site_positions}) {
        for (Vec2& p : *points) p += way;
    }
    return tile;
}

}  // namespace pcvt
