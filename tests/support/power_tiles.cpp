#include "tests/support/power_tiles.hpp"

#include "mesher/areas/target_areas.hpp"

namespace pcvt::testing {

std::vector<CellShape> cell_shapes() {
    return {{"power", "lognormal:0.42"},
            {"elongated", "", Metric(3, 30)},
            {"elongated power", "gamma:0.3", Metric(0.4, -77.25)}};
}

AreaCvtResult power_cells(const Lattice& lattice, int n, int seed, const CellShape& shape,
                          int centroidal_steps) {
    const Lattice round = shape.metric.to_round(lattice);
    const Points points = shape.metric.to_round(uniform_points(lattice, n, seed));
    const AreaLaw law = parse_area_law(*shape.law == '\0' ? "equal" : shape.law);
    return compute_area_cvt(round, points,
                            {.areas = scaled_areas(draw_areas(law, n, seed), n, lattice.area()),
                             .centroidal_steps = centroidal_steps});
}

Tile power_tile(const Lattice& lattice, int n, int seed, const CellShape& shape,
                TileOptions options, int centroidal_steps) {
    if (!shape.metric.is_round()) options.elongation = Elongation{shape.metric, lattice};
    if (*shape.law == '\0') {
        const Points points = shape.metric.to_round(uniform_points(lattice, n, seed));
        const Sites sites(shape.metric.to_round(lattice), points);
        return build_tile(PeriodicDelaunay(sites), options).tile;
    }
    const AreaCvtResult cells = power_cells(lattice, n, seed, shape, centroidal_steps);
    return build_tile(cells.delaunay, options).tile;
}

std::vector<TileOptions> tile_kinds() {
    std::vector<TileOptions> kinds;
    const auto add = [&kinds](MeshKind kind, Outline outline, int columns) -> TileOptions& {
        TileOptions& options = kinds.emplace_back();
        options.kind = kind;
        options.outline = outline;
        options.columns = columns;
        return options;
    };
    for (const int columns : {1, 2}) {
        for (const Outline outline : {Outline::kWhole, Outline::kBox}) {
            add(MeshKind::kVoronoi, outline, columns);
            add(MeshKind::kGrains, outline, columns);
            TileOptions& second_order = add(MeshKind::kGrains, outline, columns);
            second_order.grain_per_edge = 1;
            second_order.order = 2;
            second_order.rows = 2;
        }
        add(MeshKind::kDelaunay, Outline::kWhole, columns);
    }
    add(MeshKind::kVoronoi, Outline::kWhole, 1).short_edges = 0.2;
    return kinds;
}

}  // namespace pcvt::testing
