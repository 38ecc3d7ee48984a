#include "io/gltf/gltf_periodic.hpp"

#include "io/tiles/tile_file.hpp"

namespace pcvt {
namespace {

int period_count(const GltfDocument& document, const Json& periods, std::size_t k) {
    const std::size_t n =
        periods.is_array() && periods.size() == 2 ? document.count(periods[k], "periods") : 0;
    if (n < 1 || n > std::size_t{kMostPeriods}) {
        document.throw_bad_file("extras.periodic.periods is not [columns, rows]");
    }
    return static_cast<int>(n);
}

}  // namespace

void read_site_positions(const GltfDocument& document, const Json& periodic, Tile& tile) {
    const Json& accessor = GltfDocument::member(periodic, "sitePositions");
    const Json& periods = GltfDocument::member(periodic, "periods");
    if (accessor.is_null() && periods.is_null()) return;
    if (accessor.is_null() || tile.sites().empty()) {
        document.throw_bad_file(
            "extras.periodic has periods without sitePositions, or positions of sites without ids");
    }
    tile.columns = periods.is_null() ? 1 : period_count(document, periods, 0);
    tile.rows = periods.is_null() ? 1 : period_count(document, periods, 1);
    tile.short_edges = 0;
    const Json& short_edges = GltfDocument::member(periodic, "shortEdges");
    if (!short_edges.is_null()) {
        tile.short_edges = short_edges.is_number() ? short_edges.get<double>() : 0;
        if (!(tile.short_edges > 0 && tile.short_edges <= kLongestRemovedEdge)) {
            document.throw_bad_file("extras.periodic.shortEdges is not from 0 to 1");
        }
    }
    const std::vector<float> numbers =
        document.floats(document.count(accessor, "sitePositions"), 2);
    for (std::size_t k = 0; k < numbers.size(); k += 2) {
        tile.site_positions.emplace_back(numbers[k], numbers[k + 1]);
    }
}

}  // namespace pcvt
