#include "mesher/plane/proof/round_tile.hpp"

namespace pcvt::plane {

Tile round_tile(Tile tile) {
    if (tile.metric.is_round()) return tile;
    for (std::vector<Vec2>* points :
         {&tile.points, &tile.site_points, &tile.grain_site_points, &tile.site_positions}) {
        for (Vec2& p : *points) p = tile.metric.to_round(p);
    }
    tile.lattice = tile.metric.to_round(tile.lattice);
    tile.metric = {};
    return tile;
}

}  // namespace pcvt::plane
