#include "io/gltf/gltf_place.hpp"

#include "mesher/plane/tile/texture_coordinates.hpp"

namespace pcvt {

plane::Vec2 gltf_translation(const plane::Tile& tile) {
    return tile.lattice.to_position(distant_periods(tile));
}

plane::Tile moved_by(plane::Tile tile, const plane::Vec2& way) {
    for (std::vector<plane::Vec2>* points :
         {&tile.points, &tile.site_points, &tile.grain_site_points, &tile.site_positions}) {
        for (plane::Vec2& p : *points) p += way;
    }
    return tile;
}

}  // namespace pcvt
