#include "io/pictures/cut_lines.hpp"

#include "io/forms/finite.hpp"
#include "mesher/plane/tile/tile_edges.hpp"

namespace pcvt {
namespace {

/// Steps of a millimetre to which lengths in millimetres are rounded.
constexpr double kSteps = 1e6;

}  // namespace

CutLines cut_lines(const plane::Tile& tile, double width) {
    require_finite(tile);
    plane::Vec2 low = tile.points.front();
    plane::Vec2 high = low;
    for (const plane::Vec2& p : tile.points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const auto place = [&](const plane::Vec2& p) -> plane::Vec2 {
        if (width == 0) return p - low;
        const plane::Vec2 scaled = width / (high.x() - low.x()) * (p - low);
        return (kSteps * scaled).array().round().matrix() / kSteps;
    };
    CutLines lines{{}, {}, place(high)};
    for (const plane::TileEdge& edge : tile_edges(tile)) {
        (edge.on_seam || edge.right < 0 ? lines.seam : lines.inner)
            .push_back({place(tile.points[edge.v]), place(tile.points[edge.w])});
    }
    return lines;
}

}  // namespace pcvt
